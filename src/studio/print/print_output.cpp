#include "studio/print/print_output.h"

#include <QBuffer>
#include <QPdfWriter>
#include <QPrinter>
#include <QSvgGenerator>

#include "base/error.h"
#include "base/file.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kPdfDots = 1200;  // an inch
constexpr int kSvgDots = 254;

void write(const std::filesystem::path& file, const QByteArray& content) {
  writeFileAtomically(file, std::as_bytes(std::span(content.constData(), std::size_t(content.size()))));
}

}  // namespace

void printTo(QPrinter& printer, const std::vector<PrintPage>& pages) {
  QPainter painter(&printer);
  const QRectF area(QPointF(0, 0), printer.pageLayout().paintRectPixels(printer.resolution()).size());
  for (std::size_t i = 0; i < pages.size(); ++i) {
    if (i > 0) printer.newPage();
    pages[i].paint(painter, area);
  }
}

void writePdf(const std::filesystem::path& file, const std::vector<PrintPage>& pages,
              const QPageLayout& layout, const QString& title) {
  requireWritable(file);
  QByteArray content;
  QBuffer buffer(&content);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter pdf(&buffer);
    pdf.setResolution(kPdfDots);
    pdf.setPageLayout(layout);
    pdf.setTitle(title);
    pdf.setCreator(QStringLiteral("IDAP"));
    QPainter painter(&pdf);
    const QRectF area(QPointF(0, 0), pdf.pageLayout().paintRectPixels(kPdfDots).size());
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (i > 0) pdf.newPage();
      pages[i].paint(painter, area);
    }
  }
  write(file, content);
}

std::vector<std::filesystem::path> writeSvg(const std::filesystem::path& file,
                                            const std::vector<PrintPage>& pages, const QPageLayout& layout,
                                            const QString& title) {
  std::vector<std::filesystem::path> files;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    std::filesystem::path name = file;
    if (pages.size() > 1) {
      std::string stem = file.stem().string();
      stem += '-';
      stem += std::to_string(i + 1);
      stem += file.extension().string();
      name.replace_filename(stem);
    }
    requireWritable(name);
    QByteArray content;
    QBuffer buffer(&content);
    buffer.open(QIODevice::WriteOnly);
    {
      QSvgGenerator svg;
      svg.setOutputDevice(&buffer);
      svg.setResolution(kSvgDots);
      const QSizeF paper = layout.fullRect(QPageLayout::Millimeter).size();
      const QSize dots(qRound(paper.width() * 10), qRound(paper.height() * 10));
      svg.setSize(dots);
      svg.setViewBox(QRect(QPoint(0, 0), dots));
      svg.setTitle(title);
      svg.setDescription(pages[i].title);
      QPainter painter(&svg);
      const QRectF inner = layout.paintRect(QPageLayout::Millimeter);
      pages[i].paint(painter, QRectF(inner.topLeft() * 10, inner.size() * 10));
    }
    write(name, content);
    files.push_back(name);
  }
  return files;
}

}  // namespace idap
