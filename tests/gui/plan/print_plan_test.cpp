// Paper: a metre at 1:50 measures 20 mm, and what is printed are vectors.
#include "studio/plan/print_plan.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPdfWriter>
#include <QPrinter>
#include <QTemporaryDir>

#include "support/sample_home.h"

namespace idap {
namespace {

constexpr double kDots = 10;  // a millimetre

class PrintPlanTest : public testing::Test {
 protected:
  PrintPlanTest() {
    Home home = test::smallFlat();
    home.title = "Small flat";
    home.site.compassVisible = false;
    editor.open(std::make_unique<Document>(std::move(home)));
  }
  QImage page(const PrintSettings& settings) {
    QImage image(int(277 * kDots), int(190 * kDots), QImage::Format_RGB32);
    image.setDotsPerMeterX(int(kDots * 1000));
    image.setDotsPerMeterY(int(kDots * 1000));
    image.fill(Qt::white);
    QPainter painter(&image);
    printPlan(painter, QRectF(image.rect()), editor, settings);
    return image;
  }
  static bool dark(const QImage& image, int x, int y) { return qGray(image.pixel(x, y)) < 128; }

  Editor editor{std::make_shared<Catalog>(std::vector<std::filesystem::path>{})};
};

TEST_F(PrintPlanTest, ScalesAreExact) {
  for (const double scale : {1.0 / 50, 1.0 / 100}) {
    const QImage image = page({.plane = Plane::XY, .scale = scale, .titleBlock = false});
    int left = image.width(), right = 0, top = image.height(), bottom = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (dark(image, x, y))
          left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
          bottom = std::max(bottom, y);
    // 6.2 by 4.2 m over the outer faces of the walls; the line around them is 0.2 mm wide.
    EXPECT_NEAR((right - left + 1) / kDots, 6200 * scale, 0.5);
    EXPECT_NEAR((bottom - top + 1) / kDots, 4200 * scale, 0.5);
  }
}

TEST_F(PrintPlanTest, WithoutAScaleTheRoundOneThatFitsIsTaken) {
  EXPECT_NEAR(fittingScale(editor, Plane::XY, {277, 190}, true), 1.0 / 50, 1e-9);
  EXPECT_NEAR(fittingScale(editor, Plane::XY, {190, 130}, true), 1.0 / 50, 1e-9);
  EXPECT_NEAR(fittingScale(editor, Plane::XY, {100, 80}, false), 1.0 / 75, 1e-9);
}

TEST_F(PrintPlanTest, TheTitleBlockStandsBelowTheDrawing) {
  const QImage image = page({});
  const QString folder = qEnvironmentVariable("IDAP_SHOTS");
  if (!folder.isEmpty()) image.save(folder + QStringLiteral("/print.png"));
  const auto inked = [&](int from, int to) {
    int sum = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < image.width(); ++x) sum += dark(image, x, y) ? 1 : 0;
    return sum;
  };
  EXPECT_GT(inked(int(168 * kDots), image.height()), 2000);
}

TEST_F(PrintPlanTest, PrintsToAPdfOfVectors) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("plan.pdf"));
  QPrinter printer(QPrinter::HighResolution);
  printer.setOutputFormat(QPrinter::PdfFormat);
  printer.setOutputFileName(file);
  printer.setPageOrientation(QPageLayout::Landscape);
  printPlan(printer, editor, {});
  QFile pdf(file);
  ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
  const QByteArray bytes = pdf.readAll();
  EXPECT_TRUE(bytes.startsWith("%PDF"));
  EXPECT_FALSE(bytes.contains("/Subtype /Image"));
}

}  // namespace
}  // namespace idap
