// Real homes in all planes, light and dark: drawn wholly, and saved to be looked at where $IDAP_SHOTS says
// so.
#include <gtest/gtest.h>

#include <QApplication>
#include <filesystem>

#include "formats/registry.h"
#include "gui/support/gui_support.h"
#include "studio/plan/plan_view.h"

namespace idap {
namespace {

std::vector<std::filesystem::path> homes() {
  const std::filesystem::path source = IDAP_SOURCE_DIR;
  std::vector<std::filesystem::path> all{source / "share/samples/apartment.idap"};
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(source / "../shared/homes", none))
    if (entry.path().extension() == ".sh3d") all.push_back(entry.path());
  return all;
}

QPalette darkPalette() {
  QPalette dark;
  dark.setColor(QPalette::Window, QColor(45, 47, 51));
  dark.setColor(QPalette::WindowText, QColor(228, 228, 228));
  dark.setColor(QPalette::Base, QColor(32, 33, 36));
  dark.setColor(QPalette::Text, QColor(228, 228, 228));
  dark.setColor(QPalette::Button, QColor(53, 55, 60));
  dark.setColor(QPalette::ButtonText, QColor(228, 228, 228));
  dark.setColor(QPalette::Highlight, QColor(70, 140, 230));
  return dark;
}

TEST(PlanPictures, HomesAreDrawnInAllPlanes) {
  const bool all = !qEnvironmentVariableIsEmpty("IDAP_SHOTS");
  for (const auto& file : homes()) {
    if (!all && file.extension() != ".idap") continue;
    Editor editor(std::make_shared<Catalog>());
    editor.open(std::make_unique<Document>(readHome(file).home));
    for (const Plane plane : kPlanes) {
      PlanView view(editor, plane);
      view.resize(1280, 800);
      view.show();
      for (const bool dark : {false, true}) {
        if (dark) view.setPalette(darkPalette());
        view.repaint();
        EXPECT_TRUE(test::waitFor(
            [&] {
              view.repaint();
              return view.settled();
            },
            60'000));
        test::waitFor([] { return false; }, 150);  // symbols are told of a little later
        view.repaint();
        const std::string name = file.stem().string() +
                                 (plane == Plane::XY   ? "-xy"
                                  : plane == Plane::XZ ? "-xz"
                                                       : "-yz") +
                                 (dark ? "-dark" : "");
        test::shoot(view, name.c_str());
      }
      const QImage image = view.grab().toImage();
      const QColor paper = darkPalette().color(QPalette::Base);
      std::size_t drawn = 0;
      for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4) drawn += image.pixelColor(x, y) != paper ? 1 : 0;
      EXPECT_GT(drawn, std::size_t(image.width()) * std::size_t(image.height()) / 16 / 20) << file;
    }
  }
}

TEST(PlanPictures, WhatIsSelectedIsMarkedAndCanBeGrasped) {
  Editor editor(std::make_shared<Catalog>());
  editor.open(std::make_unique<Document>(readHome(homes().front()).home));
  PlanView view(editor, Plane::XY);
  view.resize(1280, 800);
  view.show();
  const auto picture = [&] {
    test::waitFor([&] {
      view.repaint();
      return view.settled();
    });
    test::waitFor([] { return false; }, 150);
    return view.grab().toImage();
  };
  const QImage before = picture();
  Elements chosen;
  for (const auto& [id, piece] : editor.home().furniture)
    if (piece->size.x > 1.5 && piece->size.z < 1.5 && chosen.furniture.empty())
      chosen.furniture.push_back(id);
  ASSERT_FALSE(chosen.furniture.empty());
  editor.select(chosen);
  const QImage after = picture();
  test::shoot(view, "apartment-selected");
  EXPECT_NE(before, after);
  EXPECT_FALSE(editor.tool().overlay(editor, Plane::XY, view.pixel()).handles.empty());
}

}  // namespace
}  // namespace idap
