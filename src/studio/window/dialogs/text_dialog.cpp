#include "studio/window/dialogs/text_dialog.h"

#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "studio/widgets/texts.h"

namespace idap {

TextDialog::TextDialog(Editor& editor, QWidget* parent)
    : FormDialog("textDialog", parent),
      editor_(editor),
      name_(new QLineEdit(this)),
      title_(new QLineEdit(this)),
      notes_(new QPlainTextEdit(this)) {
  title_->setObjectName(QStringLiteral("title"));
  name_->setObjectName(QStringLiteral("name"));
  notes_->setObjectName(QStringLiteral("notes"));
  title_->setText(toQt(editor.home().title));
  name_->setText(toQt(editor.home().name));
  notes_->setPlainText(toQt(editor.home().notes));
  notes_->setTabChangesFocus(true);
  titleLabel_ = addRow(title_);
  nameLabel_ = addRow(name_);
  notesLabel_ = addRow(notes_);
  const int em = fontMetrics().height();
  resize(30 * em, 18 * em);
  title_->setFocus();
  retranslate();
}

void TextDialog::retranslate() {
  setWindowTitle(tr("Title and notes"));
  titleLabel_->setText(tr("&Title"));
  nameLabel_->setText(tr("Na&me of the home"));
  notesLabel_->setText(tr("&Notes"));
  title_->setToolTip(tr("Printed above the plan"));
  notes_->setToolTip(tr("Anything worth remembering about this home; kept in its file"));
}

bool TextDialog::apply() {
  return editor_.apply(QT_TRANSLATE_NOOP("idap", "Title and notes"), [this](const Home& home) {
    Home changed = home;
    changed.name = fromQt(name_->text());
    changed.title = fromQt(title_->text());
    changed.notes = fromQt(notes_->toPlainText());
    return changed;
  });
}

}  // namespace idap
