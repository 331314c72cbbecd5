// The chapters about seeing and showing: live view, print sheets, own furniture, picture and film window.
#pragma once

#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>

#include "gui/screenshots/photographer.h"
#include "studio/picture/picture_form.h"
#include "studio/picture/picture_queue.h"
#include "studio/picture/picture_window.h"
#include "studio/view3d/live_panel.h"
#include "studio/view3d/view3d.h"

namespace idap {

class ShowingPictures : public Photographer {
 public:
  using Photographer::Photographer;

 protected:
  void liveView() {
    ViewArea& views = window_->views();
    editor().select({});
    views.maximise(3);
    const auto refined = [&] {
      (void)QTest::qWaitFor(
          [&] { return views.live().view().upToDate() && views.live().view().samples() >= 16; }, 60'000);
    };
    for (const auto& [id, camera] : editor().home().cameras) {
      views.live().setCamera(id);
      refined();
      shoot(("live-camera-" + std::to_string(id.value)).c_str());
    }
    views.live().setCamera({});
    refined();
    shoot("live-above");
    select("idap/sofa-three");
    shoot("live-selected");
    auto* light = part<QToolButton>(&views.live(), "light");
    light->click();
    QTest::qWait(200);
    if (QWidget* popup = QApplication::activePopupWidget()) {
      shoot("live-light", popup);
      popup->close();
    }
    auto* tabs = part<QTabWidget>(window_.get(), "catalogTabs");
    tabs->setCurrentIndex(1);
    QTest::qWait(500);
    shoot("catalog-finishes");
    tabs->setCurrentIndex(0);
    views.maximise(ViewArea::kAll);
    editor().select({});
  }

  // Every kind of sheet in the print preview.
  void sheets() {
    const int count = part<QListWidget>(printDialog(), "sheets")->count();
    for (int k = 0; k < count; ++k) {
      QWidget* dialog = printDialog();
      auto* list = part<QListWidget>(dialog, "sheets");
      for (int i = 0; i < count; ++i) list->item(i)->setCheckState(i == k ? Qt::Checked : Qt::Unchecked);
      shootDialog(("print-" + std::to_string(k + 1)).c_str(), 1500);
    }
  }

  void ownFurniture() {
    select("idap/sofa-three");
    trigger("save-as-furniture");
    shootDialog("dialog-save-as-furniture", 6000);
    editor().select({});
  }

  void pictureWindow() {
    trigger("pictures");
    auto* window = static_cast<PictureWindow*>(topLevel("pictureWindow"));
    shoot("pictures-empty", window);
    part<QComboBox>(window, "pictureQuality")->setCurrentIndex(0);
    part<QSpinBox>(window, "pictureWidth")->setValue(480);
    part<QSpinBox>(window, "pictureHeight")->setValue(300);
    auto* views = part<QListWidget>(window, "pictureViews");
    for (int i = 0; i < views->count(); ++i)
      views->item(i)->setCheckState(i < 1 ? Qt::Unchecked : Qt::Checked);
    part<QPushButton>(window, "pictureBegin")->click();
    QTest::qWait(8000);
    shoot("pictures-tracing", window);
    (void)QTest::qWaitFor([&] { return window->queue().jobs().empty(); }, 180'000);
    QTest::qWait(500);
    const auto first = editor().home().pictures.begin();
    window->lookAt(first->first);  // from above
    shoot("pictures-gallery", window);
    editor().apply("Evening", [](const Home& before) {
      Home home = before;
      home.site.time += 5 * 3'600'000LL;
      return home;
    });
    part<QToolButton>(window, "makeAgain")->click();
    (void)QTest::qWaitFor([&] { return window->queue().jobs().empty(); }, 180'000);
    QTest::qWait(500);
    shoot("pictures-compared", window);
    window->close();
  }

  void filmWindow() {
    trigger("film");
    QWidget* window = topLevel("filmWindow");
    QTest::qWait(1500);
    shoot("film", window);
    window->close();
  }

 private:
  QWidget* printDialog() {
    if (QWidget* dialog = topDialog()) return dialog;
    trigger("print");
    (void)QTest::qWaitFor([this] { return topDialog() != nullptr; }, 2000);
    return topDialog();
  }
};

}  // namespace idap
