#include "studio/catalog/finish_panel.h"

#include <QEvent>
#include <QLineEdit>

#include "model/edits/finish_edits.h"
#include "studio/widgets/material_list.h"
#include "studio/widgets/texts.h"

namespace idap {

FinishPanel::FinishPanel(Editor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      search_(new QLineEdit(this)),
      list_(new MaterialList(this)),
      hint_(new QLabel(this)) {
  search_->setObjectName(QStringLiteral("finishSearch"));
  search_->setClearButtonEnabled(true);
  list_->setObjectName(QStringLiteral("finishList"));
  list_->setDragDropMode(QAbstractItemView::DragOnly);
  list_->setLanguage(editor.settings().language);
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(4);
  column->addWidget(search_);
  column->addWidget(list_, 1);
  column->addWidget(hint_);
  setFocusProxy(search_);
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& query) { list_->fill(query); });
  connect(search_, &QLineEdit::returnPressed, this, [this] { giveToSelection(list_->current()); });
  connect(list_, &MaterialList::confirmed, this, [this](const QString& id) { giveToSelection(fromQt(id)); });
  subscription_ = editor.subscribe({.changed = [this](Editor::Change change) {
    if (change != Editor::Change::Settings) return;
    list_->setLanguage(editor_.settings().language);
    list_->fill(search_->text());
  }});
  retranslate();
}

FinishPanel::~FinishPanel() { editor_.unsubscribe(subscription_); }

void FinishPanel::retranslate() {
  search_->setPlaceholderText(tr("Search finishes"));
  search_->setAccessibleName(tr("Search finishes"));
  list_->setAccessibleName(tr("Finishes"));
  hint_->setText(
      tr("Drag one onto a wall, a floor or a piece. A double click gives it to what is selected."));
  list_->fill(search_->text());
}

void FinishPanel::giveToSelection(const std::string& material) {
  if (material.empty()) return;
  const Elements selection = editor_.selection();
  if (empty(selection)) {
    editor_.say(
        QT_TRANSLATE_NOOP("idap", "Select a wall, a room or a piece first, or drag the finish onto it"));
    return;
  }
  Finish finish;
  finish.material = material;
  editor_.apply(QT_TRANSLATE_NOOP("idap", "Change finish"),
                [&](const Home& home) { return withFinish(home, selection, {}, finish); });
}

void FinishPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace idap
