#include "studio/print/print_command.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <cstdio>

#include "base/error.h"
#include "formats/registry.h"
#include "studio/print/print_output.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

struct UsageProblem {
  QString what;
};

double scaleOf(const QString& text) {
  if (text == QLatin1String("fit")) return 0;
  bool fine = false;
  const double n = text.startsWith(QLatin1String("1:")) ? text.mid(2).toDouble(&fine) : 0;
  if (!fine || !(n >= 1 && n <= 100000))
    throw UsageProblem{QStringLiteral("--scale %1: give 1:50 or fit").arg(text)};
  return 1 / n;
}

SheetKind sheetOf(const QString& word) {
  static const std::pair<const char*, SheetKind> kWords[] = {{"plan", SheetKind::Plan},
                                                             {"xz", SheetKind::Front},
                                                             {"yz", SheetKind::Side},
                                                             {"walls", SheetKind::WallElevations},
                                                             {"list", SheetKind::FurnitureList},
                                                             {"pictures", SheetKind::Pictures}};
  for (const auto& [name, kind] : kWords)
    if (word == QLatin1String(name)) return kind;
  throw UsageProblem{QStringLiteral("--sheets %1: choose of plan, xz, yz, walls, list, pictures").arg(word)};
}

QPageSize paperOf(const QString& name) {
  for (int id = 0; id <= int(QPageSize::LastPageSize); ++id) {
    const QPageSize size{QPageSize::PageSizeId(id)};
    if (size.key().compare(name, Qt::CaseInsensitive) == 0) return size;
  }
  throw UsageProblem{QStringLiteral("--paper %1: choose A0 to A6, Letter, Legal or Tabloid").arg(name)};
}

template <class Table>
auto named(const Table& table, const QString& name, const char* what) {
  QStringList known;
  for (const auto& [id, element] : table) {
    if (toQt(element->name) == name) return id;
    if (!element->name.empty()) known << toQt(element->name);
  }
  throw Error(fromQt(QStringLiteral("no %1 '%2' in this home; it has %3")
                         .arg(QLatin1String(what), name, known.join(QStringLiteral(", ")))));
}

int run(const QCommandLineParser& args) {
  const QStringList files = args.positionalArguments();
  if (files.size() != 1) throw UsageProblem{QStringLiteral("give one home to print")};
  const QString output = args.value(QStringLiteral("output"));
  const QString suffix = QFileInfo(output).suffix().toLower();
  if (suffix != QLatin1String("pdf") && suffix != QLatin1String("svg"))
    throw UsageProblem{QStringLiteral("-o %1: the name must end in .pdf or .svg").arg(output)};
  PrintJob job;
  job.scale = scaleOf(args.value(QStringLiteral("scale")));
  job.page.setPageSize(paperOf(args.value(QStringLiteral("paper"))));
  job.page.setOrientation(args.isSet(QStringLiteral("portrait")) ? QPageLayout::Portrait
                                                                 : QPageLayout::Landscape);
  job.page.setUnits(QPageLayout::Millimeter);
  job.page.setMargins(QMarginsF(10, 10, 10, 10));
  job.titleBlock = !args.isSet(QStringLiteral("no-title"));
  job.allLevels = !args.isSet(QStringLiteral("level"));
  job.sheets.clear();
  for (const QString& word : args.value(QStringLiteral("sheets")).split(QLatin1Char(','), Qt::SkipEmptyParts))
    job.sheets.push_back(sheetOf(word.trimmed()));

  ReadResult read = readHome(fromQt(files.front()));
  for (const ImportReport::Entry& entry : read.report.entries)
    std::fprintf(stderr, "idap: %s: %s\n", entry.place.c_str(), entry.what.c_str());
  if (args.isSet(QStringLiteral("title"))) read.home.title = fromQt(args.value(QStringLiteral("title")));
  Editor editor(std::make_shared<const Catalog>());
  EditorSettings settings;
  settings.language = fromQt(args.value(QStringLiteral("language")));
  if (args.value(QStringLiteral("unit")) == QLatin1String("inch")) settings.unit = LengthUnit::FeetInches;
  if (args.value(QStringLiteral("unit")) == QLatin1String("m")) settings.unit = LengthUnit::Metre;
  editor.setSettings(settings);
  editor.open(std::make_unique<Document>(read.home));
  PrintSource source = printSource(editor);
  if (args.isSet(QStringLiteral("level")))
    source.level = named(read.home.levels, args.value(QStringLiteral("level")), "level");
  if (args.isSet(QStringLiteral("room"))) {
    job.room = named(read.home.rooms, args.value(QStringLiteral("room")), "room");
    source.level = read.home.rooms.find(*job.room)->level;
  }
  const std::vector<PrintPage> pages = layOut(source, job);
  if (pages.empty()) throw Error("there is nothing to print: the home has none of what these sheets show");
  const QString title = toQt(read.home.title.empty() ? read.home.name : read.home.title);
  if (suffix == QLatin1String("pdf"))
    writePdf(fromQt(output), pages, job.page, title);
  else
    writeSvg(fromQt(output), pages, job.page, title);
  return 0;
}

}  // namespace

int runPrintCommand(const QStringList& arguments) {
  QCommandLineParser args;
  args.addPositionalArgument(QStringLiteral("FILE"), {});
  const auto option = [&](const QStringList& names, const char* value, const char* preset) {
    args.addOption({names, {}, QLatin1String(value), QLatin1String(preset)});
  };
  option({QStringLiteral("o"), QStringLiteral("output")}, "FILE", "");
  option({QStringLiteral("scale")}, "1:N", "fit");
  option({QStringLiteral("paper")}, "NAME", "A4");
  option({QStringLiteral("sheets")}, "LIST", "plan");
  option({QStringLiteral("level")}, "NAME", "");
  option({QStringLiteral("room")}, "NAME", "");
  option({QStringLiteral("title")}, "TEXT", "");
  option({QStringLiteral("language")}, "CODE", "en");
  option({QStringLiteral("unit")}, "UNIT", "cm");
  args.addOption({QStringLiteral("portrait"), {}});
  args.addOption({QStringLiteral("no-title"), {}});
  try {
    if (!args.parse(QStringList{QStringLiteral("idap")} + arguments)) throw UsageProblem{args.errorText()};
    return run(args);
  } catch (const UsageProblem& problem) {
    std::fprintf(stderr, "idap: %s\n", qUtf8Printable(problem.what));
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "idap: %s\n", error.what());
    return 1;
  }
}

}  // namespace idap
