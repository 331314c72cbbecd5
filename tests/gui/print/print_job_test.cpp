// Paper: a metre at 1:50 measures 20 mm, measured in the PDFs themselves; fonts are in them; Thai can be
// read.
#include "editor/editor.h"

#include <gmock/gmock.h>

#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include "base/error.h"
#include "model/edits/piece_edits.h"
#include "studio/print/print_output.h"
#include "support/sample_home.h"

namespace idap {
namespace {

using testing::HasSubstr;

constexpr double kDots = 20;  // a millimetre, of the pages that are measured

class PrintJobTest : public testing::Test {
 protected:
  PrintJobTest() {
    Home home = test::smallFlat();
    home.title = "Attic";
    home.notes = "For the builder";
    home.site.compassVisible = false;
    editor.open(std::make_unique<Document>(std::move(home)));
  }
  std::vector<PrintPage> pages(const PrintJob& job) { return layOut(printSource(editor), job); }
  QString pdf(const PrintJob& job) {
    const QString file = folder.filePath(QStringLiteral("plan.pdf"));
    writePdf(file.toStdString(), pages(job), job.page, QStringLiteral("Attic"));
    return file;
  }
  // What a program of Poppler says; skips the test where it is not installed.
  QByteArray poppler(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    EXPECT_TRUE(process.waitForFinished(60'000));
    return process.readAllStandardOutput();
  }
  static bool hasPoppler() { return !QStandardPaths::findExecutable(QStringLiteral("pdftoppm")).isEmpty(); }
  QImage page(const QString& file, int number = 1) {
    const QString picture = folder.filePath(QStringLiteral("page"));
    poppler(QStringLiteral("pdftoppm"),
            {"-r", QString::number(25.4 * kDots), "-f", QString::number(number), "-l",
             QString::number(number), "-singlefile", "-png", file, picture});
    return QImage(picture + QStringLiteral(".png"));
  }
  // mm, around all that is dark.
  static QRectF inked(const QImage& image) {
    int left = image.width(), right = 0, top = image.height(), bottom = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        if (qGray(image.pixel(x, y)) < 128)
          left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
          bottom = std::max(bottom, y);
    return QRectF(left / kDots, top / kDots, (right - left + 1) / kDots, (bottom - top + 1) / kDots);
  }

  QTemporaryDir folder;
  Editor editor{std::make_shared<Catalog>(std::vector<std::filesystem::path>{})};
};

TEST_F(PrintJobTest, AtOneToFiftyTheFlatMeasuresAFiftieth) {
  if (!hasPoppler()) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
  QRectF larger;
  for (const auto orientation : {QPageLayout::Landscape, QPageLayout::Portrait}) {
    for (const double scale : {1.0 / 50, 1.0 / 100}) {
      PrintJob job;
      job.scale = scale;
      job.titleBlock = false;
      job.page.setOrientation(orientation);
      const QRectF ink = inked(page(pdf(job)));
      // 6.2 by 4.2 m over the outer faces of the walls; the line around them adds a quarter of a millimetre.
      EXPECT_NEAR(ink.width(), 6200 * scale, 0.45);
      EXPECT_NEAR(ink.height(), 4200 * scale, 0.45);
      // What the line adds is the same at both scales: their difference is exact.
      if (scale == 1.0 / 50) {
        larger = ink;
      } else {
        EXPECT_NEAR(larger.width() - ink.width(), 62, 0.11);
        EXPECT_NEAR(larger.height() - ink.height(), 42, 0.11);
      }
    }
  }
}

TEST_F(PrintJobTest, WhatIsTooLargeGoesOverPagesThatTogetherShowAllAtThatScale) {
  if (!hasPoppler()) GTEST_SKIP() << "needs pdftoppm (poppler-utils)";
  PrintJob job;
  job.scale = 1.0 / 20;  // 310 by 210 mm on 277 by 190
  job.titleBlock = false;
  const std::vector<PrintPage> all = pages(job);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_THAT(all[0].title.toStdString(), HasSubstr("A1"));
  EXPECT_THAT(all[3].title.toStdString(), HasSubstr("B2"));
  const QString file = pdf(job);
  // The left wall on the first page and the right one on the second, 277 - 10 mm further on.
  const auto wallAt = [](const QImage& image, bool first) {
    const int y = int(image.height() * 0.5);
    int found = -1;
    for (int x = int(16 * kDots); x < image.width() - int(24 * kDots); ++x)
      if (qGray(image.pixel(x, y)) < 128 && (found < 0 || !first)) found = x;
    return found / kDots;
  };
  const double left = wallAt(page(file, 1), true), right = wallAt(page(file, 2), false);
  EXPECT_NEAR(right + 277 - 10 - left, 6200.0 / 20, 0.6);
}

TEST_F(PrintJobTest, WithoutAScaleTheRoundOneThatFitsIsTaken) {
  PrintJob job;
  EXPECT_NEAR(pages(job).front().scale, 1.0 / 50, 1e-9);
  job.page.setPageSize(QPageSize(QPageSize::A6));
  EXPECT_NEAR(pages(job).front().scale, 1.0 / 100, 1e-9);
}

TEST_F(PrintJobTest, ThePaperIsOfItsSizeAndTheFontsAreInTheFile) {
  if (!hasPoppler()) GTEST_SKIP() << "needs pdffonts (poppler-utils)";
  PrintJob job;
  job.page.setPageSize(QPageSize(QPageSize::A3));
  const QString file = pdf(job);
  EXPECT_THAT(poppler("pdfinfo", {file}).toStdString(), HasSubstr("(A3)"));
  const QList<QByteArray> fonts = poppler("pdffonts", {file}).split('\n');
  ASSERT_GT(fonts.size(), 3);
  for (qsizetype i = 2; i < fonts.size() - 1; ++i)
    EXPECT_TRUE(fonts[i].contains(" yes ")) << fonts[i].toStdString();
}

TEST_F(PrintJobTest, TheTitleBlockSaysTitleNotesAndScale) {
  if (!hasPoppler()) GTEST_SKIP() << "needs pdftotext (poppler-utils)";
  PrintJob job;
  job.scale = 1.0 / 50;
  const std::string text = poppler("pdftotext", {"-layout", pdf(job), "-"}).toStdString();
  EXPECT_THAT(text, HasSubstr("Attic"));
  EXPECT_THAT(text, HasSubstr("For the builder"));
  EXPECT_THAT(text, HasSubstr("1:50"));
}

TEST_F(PrintJobTest, ThaiTitlesComeOutAsThai) {
  if (!hasPoppler()) GTEST_SKIP() << "needs pdftotext (poppler-utils)";
  editor.apply("title", [](const Home& before) {
    Home home = before;
    home.title = "บ้านหลังเล็ก";
    return home;
  });
  const QString text = QString::fromUtf8(poppler("pdftotext", {"-layout", pdf({}), "-"}));
  EXPECT_TRUE(text.contains(QStringLiteral("หลังเล็ก"))) << text.toStdString();
}

TEST_F(PrintJobTest, EveryWallOfTheRoomHasItsElevation) {
  editor.open(std::make_unique<Document>(makeRoomHome(4, 3, 2.5, 0.1, "Study")));
  PrintJob job;
  job.sheets = {SheetKind::WallElevations};
  const std::vector<PrintPage> all = pages(job);
  ASSERT_FALSE(all.empty());
  if (!hasPoppler()) GTEST_SKIP() << "needs pdftotext (poppler-utils)";
  const std::string text = poppler("pdftotext", {"-layout", pdf(job), "-"}).toStdString();
  EXPECT_THAT(text, HasSubstr("wall A"));
  EXPECT_THAT(text, HasSubstr("wall D"));
  EXPECT_THAT(text, HasSubstr("400"));
  EXPECT_THAT(text, HasSubstr("250"));
}

TEST_F(PrintJobTest, TheListCountsAndSums) {
  editor.apply("price", [](const Home& before) {
    Home home = before;
    for (const auto& [id, piece] : before.furniture) {
      Furniture priced = *piece;
      priced.name = "Table";
      priced.price = 120.5;
      home.furniture.set(id, priced);
    }
    Furniture second = *home.furniture.begin()->second;
    home.furniture.set(home.newId<FurnitureId>(), second);
    return home;
  });
  PrintJob job;
  job.sheets = {SheetKind::FurnitureList};
  EXPECT_EQ(pages(job).size(), 1u);
  if (!hasPoppler()) GTEST_SKIP() << "needs pdftotext (poppler-utils)";
  const std::string text = poppler("pdftotext", {"-layout", pdf(job), "-"}).toStdString();
  EXPECT_THAT(text, HasSubstr("Table"));
  EXPECT_THAT(text, HasSubstr("241.00"));
}

TEST_F(PrintJobTest, AnSvgIsAsLargeAsItsPaperAndADrawingOfVectors) {
  PrintJob job;
  job.sheets = {SheetKind::Plan, SheetKind::Front};
  const std::string file = folder.filePath(QStringLiteral("plan.svg")).toStdString();
  const auto files = writeSvg(file, pages(job), job.page, QStringLiteral("x"));
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].filename(), "plan-1.svg");
  QFile svg(QString::fromStdString(files[0].string()));
  ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
  const QByteArray text = svg.readAll();
  EXPECT_TRUE(text.contains("width=\"297mm\"")) << text.left(400).toStdString();
  EXPECT_TRUE(text.contains("height=\"210mm\""));
  EXPECT_FALSE(text.contains("<image"));
}

TEST_F(PrintJobTest, AFolderThatIsNotThereIsSaid) {
  EXPECT_THROW(writePdf(folder.filePath("no/plan.pdf").toStdString(), pages({}), {}, {}), Error);
}

}  // namespace
}  // namespace idap
