// Pages to where they are wanted: a printer, a PDF, SVG files. Throws Error with the file and the reason.
#pragma once

#include <filesystem>
#include <vector>

#include "studio/print/print_job.h"

class QPrinter;

namespace idap {

void printTo(QPrinter& printer, const std::vector<PrintPage>& pages);
void writePdf(const std::filesystem::path& file, const std::vector<PrintPage>& pages,
              const QPageLayout& layout, const QString& title);
// One page a file: plan.svg for one page, plan-1.svg, plan-2.svg … for more; gives the files written. An SVG
// is as large as its paper, in millimetres.
std::vector<std::filesystem::path> writeSvg(const std::filesystem::path& file,
                                            const std::vector<PrintPage>& pages, const QPageLayout& layout,
                                            const QString& title);

}  // namespace idap
