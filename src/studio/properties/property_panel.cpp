#include "studio/properties/property_panel.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

#include "editor/selection.h"
#include "studio/properties/panel_title.h"
#include "studio/properties/sections.h"

namespace idap {

namespace {
constexpr int kPause = 50;  // ms between two updates while the home changes all the time
}

struct PropertyPanel::Impl {
  Impl(PropertyPanel& owner, Editor& e) : panel(owner), editor(e), link(e, &owner) {}

  PropertyPanel& panel;
  Editor& editor;
  PanelLink link;
  int subscription = 0;
  QLabel* title = nullptr;
  QLabel* subtitle = nullptr;
  QScrollArea* scroll = nullptr;
  QVBoxLayout* column = nullptr;
  std::vector<Section*> sections;  // by entry; null until it is first needed
  QTimer* timer = nullptr;
  bool dirty = true, otherThings = true;

  void build();
  void onChange(Editor::Change change);
  void ask(int delay);
  void refresh();
  void showSections(const Selected& selected);
  void putInTabOrder();
};

void PropertyPanel::Impl::build() {
  panel.setObjectName(QStringLiteral("propertyPanel"));
  sections.assign(sectionEntries().size(), nullptr);
  title = new QLabel(&panel);
  title->setObjectName(QStringLiteral("propertyTitle"));
  title->setTextFormat(Qt::PlainText);
  title->setWordWrap(true);
  QFont large = title->font();
  large.setBold(true);
  large.setPointSizeF(large.pointSizeF() * 1.2);
  title->setFont(large);
  subtitle = new QLabel(&panel);
  subtitle->setObjectName(QStringLiteral("propertySubtitle"));
  subtitle->setTextFormat(Qt::PlainText);
  subtitle->setWordWrap(true);
  subtitle->setForegroundRole(QPalette::PlaceholderText);
  for (QLabel* label : {title, subtitle}) label->setMinimumWidth(1);

  scroll = new QScrollArea(&panel);
  scroll->setObjectName(QStringLiteral("propertyScroll"));
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* content = new QWidget(scroll);
  content->setObjectName(QStringLiteral("propertyContent"));
  column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addStretch(1);
  scroll->setWidget(content);

  auto* all = new QVBoxLayout(&panel);
  all->setContentsMargins(4, 6, 0, 0);
  all->setSpacing(2);
  all->addWidget(title);
  all->addWidget(subtitle);
  all->addWidget(scroll, 1);

  timer = new QTimer(&panel);
  timer->setSingleShot(true);
  QObject::connect(timer, &QTimer::timeout, &panel, [this] { refresh(); });
  QObject::connect(&link, &PanelLink::factsReady, &panel, [this] { ask(0); });
  subscription = editor.subscribe({.changed = [this](Editor::Change change) { onChange(change); }});
}

void PropertyPanel::Impl::onChange(Editor::Change change) {
  switch (change) {
    case Editor::Change::Home:
      ask(kPause);
      break;
    case Editor::Change::Document:
    case Editor::Change::Selection:
      // What is half typed belongs to what was selected before.
      for (Section* section : sections)
        if (section)
          section->commitTyping(change == Editor::Change::Selection && !editor.document().inTransaction());
      otherThings = true;
      ask(0);
      break;
    case Editor::Change::Level:
    case Editor::Change::Settings:
      ask(0);
      break;
    default:
      break;
  }
}

void PropertyPanel::Impl::ask(int delay) {
  dirty = true;
  if (!panel.isVisible()) return;  // showEvent brings it up to date
  if (!timer->isActive() || timer->remainingTime() > delay) timer->start(delay);
}

void PropertyPanel::Impl::refresh() {
  timer->stop();
  if (!dirty) return;
  dirty = false;
  const Selected selected(editor);
  const auto [name, details] = panelTitle(selected);
  if (title->text() != name) title->setText(name);
  if (subtitle->text() != details) subtitle->setText(details);
  subtitle->setVisible(!details.isEmpty());
  showSections(selected);
  if (std::exchange(otherThings, false)) scroll->verticalScrollBar()->setValue(0);
}

void PropertyPanel::Impl::showSections(const Selected& selected) {
  const auto& entries = sectionEntries();
  bool made = false;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const bool applies = entries[i].applies(selected);
    if (!applies) {
      if (sections[i]) sections[i]->hide();
      continue;
    }
    if (!sections[i]) {
      sections[i] = entries[i].make(link, scroll->widget());
      const auto before = std::count_if(sections.begin(), sections.begin() + static_cast<std::ptrdiff_t>(i),
                                        [](const Section* s) { return s != nullptr; });
      column->insertWidget(static_cast<int>(before), sections[i]);
      made = true;
    }
    sections[i]->refresh(selected);
    sections[i]->setVisible(!sections[i]->bare());
  }
  if (made) putInTabOrder();
}

void PropertyPanel::Impl::putInTabOrder() {
  QWidget* last = nullptr;
  for (const Section* section : sections) {
    if (!section) continue;
    for (QWidget* field : section->fields()) {
      if (last) QWidget::setTabOrder(last, field);
      last = field;
    }
  }
}

PropertyPanel::PropertyPanel(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(*this, editor)) {
  impl_->build();
}

PropertyPanel::~PropertyPanel() { impl_->editor.unsubscribe(impl_->subscription); }

void PropertyPanel::focusFirst() {
  impl_->refresh();
  for (Section* section : impl_->sections) {
    if (!section || !section->isVisibleTo(this) || !section->isOpen()) continue;
    QWidget* field = section->firstField();
    if (!field) continue;
    impl_->scroll->ensureWidgetVisible(field);
    field->setFocus(Qt::TabFocusReason);
    return;
  }
}

bool PropertyPanel::event(QEvent* event) {
  if (event->type() == QEvent::Show && impl_) impl_->refresh();
  return QWidget::event(event);
}

void PropertyPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LanguageChange || !impl_) return;
  for (Section* section : impl_->sections)
    if (section) section->retranslate();
  impl_->dirty = true;
  impl_->refresh();
}

QSize PropertyPanel::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 46, fontMetrics().height() * 30};
}
QSize PropertyPanel::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 30, fontMetrics().height() * 8};
}

}  // namespace idap
