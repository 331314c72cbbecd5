#include "studio/lists/camera_list.h"

#include <QAbstractListModel>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QListView>
#include <QMenu>
#include <QToolButton>

#include "editor/selection.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

// The view from above, then the cameras in order of id.
class CameraModel : public QAbstractListModel {
 public:
  CameraModel(Editor& editor, QObject* parent) : QAbstractListModel(parent), editor_(editor) { read(); }

  void refresh() {
    std::vector<CameraId> ids;
    for (const auto& [id, camera] : editor_.home().cameras) ids.push_back(id);
    if (ids == ids_) {
      emit dataChanged(index(0), index(rowCount() - 1));
      return;
    }
    // Row by row, so that the choice stays with its camera.
    for (std::size_t i = ids_.size(); i-- > 0;)
      if (!editor_.home().cameras.contains(ids_[i])) {
        beginRemoveRows({}, int(i) + 1, int(i) + 1);
        ids_.erase(ids_.begin() + std::ptrdiff_t(i));
        endRemoveRows();
      }
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (i >= ids_.size() || ids_[i] != ids[i]) {
        beginInsertRows({}, int(i) + 1, int(i) + 1);
        ids_.insert(ids_.begin() + std::ptrdiff_t(i), ids[i]);
        endInsertRows();
      }
    emit dataChanged(index(0), index(rowCount() - 1));
  }
  void reset() {
    beginResetModel();
    read();
    endResetModel();
  }

  CameraId cameraAt(int row) const {
    return row >= 1 && row <= int(ids_.size()) ? ids_[static_cast<std::size_t>(row - 1)] : CameraId{};
  }
  int rowOf(CameraId id) const {
    const auto found = std::find(ids_.begin(), ids_.end(), id);
    return found == ids_.end() ? 0 : int(found - ids_.begin()) + 1;
  }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : int(ids_.size()) + 1;
  }
  QVariant data(const QModelIndex& index, int role) const override {
    const CameraId id = cameraAt(index.row());
    const Camera* camera = editor_.home().cameras.find(id);
    if (role == Qt::DecorationRole) return camera ? cameraIcon_ : aboveIcon_;
    if (role == Qt::ToolTipRole)
      return camera ? CameraList::tr("Double click for a picture from here; F2 renames it")
                    : CameraList::tr("The whole home from above, without ceilings");
    if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
    if (!camera) return CameraList::tr("From above");
    if (!camera->name.empty() || role == Qt::EditRole) return toQt(camera->name);
    return CameraList::tr("View %1").arg(index.row());
  }
  bool setData(const QModelIndex& index, const QVariant& value, int role) override {
    const CameraId id = cameraAt(index.row());
    const Camera* camera = editor_.home().cameras.find(id);
    if (!camera || role != Qt::EditRole) return false;
    const std::string name = fromQt(value.toString().trimmed());
    if (name == camera->name) return true;
    return editor_.apply(QT_TRANSLATE_NOOP("idap", "Rename"), [&](const Home& home) {
      Home after = home;
      Camera renamed = *camera;
      renamed.name = name;
      after.cameras.set(id, std::move(renamed));
      return after;
    });
  }
  Qt::ItemFlags flags(const QModelIndex& index) const override {
    if (!index.isValid()) return Qt::NoItemFlags;
    const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return index.row() == 0 ? usual : usual | Qt::ItemIsEditable;
  }

 private:
  void read() {
    ids_.clear();
    for (const auto& [id, camera] : editor_.home().cameras) ids_.push_back(id);
  }

  Editor& editor_;
  QIcon cameraIcon_ = icon("camera"), aboveIcon_ = icon("zoom-fit");
  std::vector<CameraId> ids_;
};

}  // namespace

struct CameraList::Impl : public QObject {
  CameraList* self;
  Editor& editor;
  CameraModel model;
  QListView* view = nullptr;
  QAction* picture = nullptr;
  QAction* add = nullptr;
  QAction* rename = nullptr;
  QAction* duplicate = nullptr;
  QAction* up = nullptr;
  QAction* down = nullptr;
  QAction* remove = nullptr;
  int subscription = 0;
  CameraId told;           // what currentChanged() was last emitted for
  bool following = false;  // the selection of the plans

  Impl(CameraList* list, Editor& e) : self(list), editor(e), model(e, nullptr) {}

  CameraId current() const { return model.cameraAt(view->currentIndex().row()); }

  QAction* make(const char* name, const char* iconName, QBoxLayout* bar, void (Impl::*run)()) {
    auto* action = new QAction(icon(iconName), {}, self);
    action->setObjectName(QString::fromLatin1(name));
    connect(action, &QAction::triggered, this, [this, run] { (this->*run)(); });
    auto* button = new QToolButton;
    button->setAutoRaise(true);
    button->setDefaultAction(action);
    button->setObjectName(QString::fromLatin1(name) + QStringLiteral("Button"));
    bar->addWidget(button);
    return action;
  }

  void build() {
    view = new QListView;
    view->setObjectName(QStringLiteral("cameras"));
    view->setModel(&model);
    view->setEditTriggers(QAbstractItemView::EditKeyPressed);
    view->setUniformItemSizes(true);
    view->setContextMenuPolicy(Qt::CustomContextMenu);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(4, 2, 4, 4);
    bar->setSpacing(2);
    picture = make("cameraPicture", "ray-trace", bar, &Impl::takePicture);
    add = make("cameraAdd", "add", bar, &Impl::addOne);
    rename = make("cameraRename", "text", bar, &Impl::renameOne);
    duplicate = make("cameraDuplicate", "duplicate", bar, &Impl::duplicateOne);
    up = make("cameraUp", "up", bar, &Impl::moveUp);
    down = make("cameraDown", "down", bar, &Impl::moveDown);
    remove = make("cameraDelete", "delete", bar, &Impl::removeOne);
    bar->addStretch(1);
    auto* layout = new QVBoxLayout(self);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(view, 1);
    layout->addLayout(bar);
    view->installEventFilter(this);
    view->setCurrentIndex(model.index(0));
    connect(view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] { onCurrent(); });
    connect(view, &QAbstractItemView::doubleClicked, this, [this] { takePicture(); });
    connect(view, &QWidget::customContextMenuRequested, this, [this](QPoint at) {
      QMenu menu;
      menu.addActions({picture, add});
      menu.addSeparator();
      menu.addActions({rename, duplicate, up, down, remove});
      menu.exec(view->viewport()->mapToGlobal(at));
    });
    enable();
  }

  // Before the window's own Delete.
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    if (!static_cast<QKeyEvent*>(event)->matches(QKeySequence::Delete)) return false;
    if (event->type() == QEvent::KeyPress) removeOne();
    event->accept();
    return true;
  }

  void retranslate() {
    const auto name = [](QAction* action, const QString& text, const QString& tip) {
      action->setText(text);
      action->setToolTip(tip);
    };
    name(picture, CameraList::tr("Picture"), CameraList::tr("Trace a picture from this point of view"));
    name(add, CameraList::tr("New"), CameraList::tr("Place another point of view on the plan"));
    name(rename, CameraList::tr("Rename"), CameraList::tr("Give it a name (F2)"));
    name(duplicate, CameraList::tr("Duplicate"),
         CameraList::tr("Another one at the same place, to be changed"));
    name(up, CameraList::tr("Up"), CameraList::tr("Earlier in the list"));
    name(down, CameraList::tr("Down"), CameraList::tr("Later in the list"));
    name(remove, CameraList::tr("Delete"), CameraList::tr("Take this point of view out of the home"));
    view->setAccessibleName(CameraList::tr("Points of view"));
    model.refresh();
  }

  void enable() {
    const CameraId id = current();
    const int row = view->currentIndex().row();
    for (QAction* action : {rename, duplicate, remove}) action->setEnabled(bool(id));
    up->setEnabled(id && row > 1);
    down->setEnabled(id && row + 1 < model.rowCount());
  }

  void onCurrent() {
    enable();
    const CameraId id = current();
    if (id == told) return;
    told = id;
    if (!following && id) editor.select(only(id));
    emit self->currentChanged();
  }

  void onChange(Editor::Change change) {
    if (change == Editor::Change::Home) {
      following = true;
      model.refresh();
      if (!view->currentIndex().isValid()) view->setCurrentIndex(model.index(0));
      following = false;
      enable();
    } else if (change == Editor::Change::Document) {
      following = true;
      model.reset();
      view->setCurrentIndex(model.index(0));
      following = false;
      onCurrent();
    } else if (change == Editor::Change::Selection) {
      const auto one = single(editor.selection());
      if (!one || !std::holds_alternative<CameraId>(*one)) return;
      following = true;
      view->setCurrentIndex(model.index(model.rowOf(std::get<CameraId>(*one))));
      following = false;
    }
  }

  void takePicture() { emit self->pictureRequested(); }
  void addOne() { editor.takeTool("camera"); }
  void renameOne() {
    if (current()) view->edit(view->currentIndex());
  }
  void duplicateOne() {
    const Camera* camera = editor.home().cameras.find(current());
    if (!camera) return;
    Camera copy = *camera;
    CameraId made;
    editor.apply(QT_TRANSLATE_NOOP("idap", "Duplicate point of view"), [&](const Home& home) {
      Home after = home;
      made = after.newId<CameraId>();
      after.cameras.set(made, copy);
      return after;
    });
    view->setCurrentIndex(model.index(model.rowOf(made)));
  }
  void removeOne() {
    const CameraId id = current();
    if (!id) return;
    editor.apply(QT_TRANSLATE_NOOP("idap", "Delete point of view"),
                 [id](const Home& home) { return deleteElements(home, only(id)); });
  }
  // Ids keep their order, so the cameras change places.
  void exchange(int with) {
    const CameraId a = current(), b = model.cameraAt(with);
    if (!a || !b) return;
    editor.apply(QT_TRANSLATE_NOOP("idap", "Order points of view"), [&](const Home& home) {
      Home after = home;
      const auto first = home.cameras.shared(a), second = home.cameras.shared(b);
      after.cameras.set(a, second);
      after.cameras.set(b, first);
      return after;
    });
    view->setCurrentIndex(model.index(with));
  }
  void moveUp() { exchange(view->currentIndex().row() - 1); }
  void moveDown() { exchange(view->currentIndex().row() + 1); }
};

CameraList::CameraList(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(this, editor)) {
  setObjectName(QStringLiteral("cameraList"));
  impl_->build();
  impl_->retranslate();
  impl_->subscription =
      editor.subscribe({.changed = [this](Editor::Change change) { impl_->onChange(change); }});
}

CameraList::~CameraList() { impl_->editor.unsubscribe(impl_->subscription); }

CameraId CameraList::current() const { return impl_->current(); }

void CameraList::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
}

}  // namespace idap
