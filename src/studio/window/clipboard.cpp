#include "studio/window/clipboard.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>

#include "formats/idap/idap_format.h"
#include "model/edits/arrange_edits.h"
#include "studio/widgets/mime_types.h"

namespace idap {

namespace {

const QMimeData* onClipboard() { return QGuiApplication::clipboard()->mimeData(); }

// What another program put there may be anything: the reader checks it as it checks files.
std::optional<Home> fragment(Editor& editor) {
  if (!canPaste()) return std::nullopt;
  const QByteArray data = onClipboard()->data(QLatin1String(kHomeMime));
  const auto* begin = reinterpret_cast<const std::byte*>(data.constData());
  try {
    ReadResult read =
        readIdap(std::make_shared<const Bytes>(begin, begin + data.size()), "clipboard", Progress());
    return std::move(read.home);
  } catch (const Error& error) {
    editor.say({QT_TRANSLATE_NOOP("idap", "What is on the clipboard cannot be pasted: %1"), {error.what()}},
               Editor::Severity::Warning);
    return std::nullopt;
  }
}

}  // namespace

void copySelection(Editor& editor) {
  if (empty(editor.selection())) return;
  try {
    const Bytes bytes = writeIdap(extractElements(editor.home(), editor.selection()), Progress());
    auto* data = new QMimeData;
    data->setData(QLatin1String(kHomeMime),
                  QByteArray(reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())));
    QGuiApplication::clipboard()->setMimeData(data);
  } catch (const Error& error) {
    editor.say({QT_TRANSLATE_NOOP("idap", "The selection cannot be copied: %1"), {error.what()}},
               Editor::Severity::Warning);
  }
}

void cutSelection(Editor& editor) {
  if (empty(editor.selection())) return;
  copySelection(editor);
  editor.apply(QT_TRANSLATE_NOOP("idap", "Cut"), [selection = editor.selection()](const Home& home) {
    return deleteElements(home, unlocked(home, selection));  // what is locked is copied, and stays
  });
}

bool canPaste() {
  const QMimeData* data = onClipboard();
  return data && data->hasFormat(QLatin1String(kHomeMime));
}

void paste(Editor& editor, PasteAs how) {
  const std::optional<Home> what = fragment(editor);
  if (!what) return;
  GroupId group;
  if (how == PasteAs::IntoGroup && editor.selection().groups.size() == 1)
    group = editor.selection().groups[0];
  const Vec3 by = how == PasteAs::Beside ? Vec3{0.2, -0.2, 0} : Vec3{};
  Elements copies;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Paste"), [&](const Home& home) {
    CopyEdit edit = pasteElements(home, *what, editor.level(), by, group);
    copies = edit.copies;
    return std::move(edit.home);
  });
  if (done) editor.select(group ? editor.selection() : copies);
}

void pasteStyle(Editor& editor) {
  const std::optional<Home> what = fragment(editor);
  if (!what || empty(editor.selection())) return;
  editor.apply(QT_TRANSLATE_NOOP("idap", "Paste style"),
               [&what, selection = editor.selection()](const Home& home) {
                 return idap::pasteStyle(home, *what, selection);
               });
}

}  // namespace idap
