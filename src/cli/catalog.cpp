#include <fmt/format.h>

#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "cli/command.h"
#include "cli/usage_error.h"

namespace idap::cli {

namespace {

struct Options {
  std::vector<std::string> query;
  std::string id, category, language = "en";
  bool json = false;
};

const char* kindName(PieceKind kind) {
  switch (kind) {
    case PieceKind::Furniture:
      return "furniture";
    case PieceKind::Lamp:
      return "lamp";
    case PieceKind::Door:
      return "door";
    case PieceKind::Window:
      return "window";
    case PieceKind::Staircase:
      return "staircase";
  }
  return "";
}

nlohmann::json toJson(const CatalogPiece& piece, const std::string& language) {
  nlohmann::json json{{"id", piece.id},
                      {"name", piece.nameIn(language)},
                      {"category", piece.category},
                      {"kind", kindName(piece.kind)},
                      {"tags", piece.tags},
                      {"width", piece.size.x},
                      {"depth", piece.size.y},
                      {"height", piece.size.z},
                      {"library", piece.library},
                      {"creator", piece.creator},
                      {"license", piece.license}};
  if (piece.price) json["price"] = *piece.price;
  if (piece.lamp) json["lumens"] = piece.lamp->lumens;
  if (!piece.slots.empty()) json["slots"] = piece.slots;
  for (const PieceParameter& p : piece.parameters)
    json["parameters"][p.name] = {{"default", p.value}, {"min", p.min}, {"max", p.max}};
  for (const auto& [code, words] : piece.translations) {
    const auto name = words.find("name");
    if (name != words.end()) json["names"][code] = name->second;
  }
  return json;
}

void printTable(const std::vector<CatalogPiecePtr>& pieces, const Options& options) {
  if (options.json) {
    auto list = nlohmann::json::array();
    for (const auto& piece : pieces) list.push_back(toJson(*piece, options.language));
    fmt::print("{}\n", list.dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  for (const auto& piece : pieces) {
    const std::string origin =
        piece->library.empty() ? "" : fmt::format("  ({}, {})", piece->creator, piece->license);
    fmt::print("{:<36} {:<34} {:<16} {:.0f} x {:.0f} x {:.0f} cm{}\n", piece->id,
               piece->nameIn(options.language), piece->category, piece->size.x * 100, piece->size.y * 100,
               piece->size.z * 100, origin);
  }
}

void printProblems(const Catalog& catalog) {
  for (const std::string& problem : catalog.problems()) fmt::print(stderr, "idap: {}\n", problem);
}

void show(const CatalogPiece& piece, const Options& options) {
  if (options.json) {
    fmt::print("{}\n",
               toJson(piece, options.language).dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
    return;
  }
  fmt::print("{}\n  id        {}\n  category  {}\n  kind      {}\n  size      {:.1f} x {:.1f} x {:.1f} cm\n",
             piece.nameIn(options.language), piece.id, piece.category, kindName(piece.kind),
             piece.size.x * 100, piece.size.y * 100, piece.size.z * 100);
  if (!piece.library.empty()) fmt::print("  library   {}\n", piece.library);
  if (!piece.creator.empty()) fmt::print("  creator   {}\n", piece.creator);
  if (!piece.license.empty()) fmt::print("  licence   {}\n", piece.license);
  if (piece.lamp) fmt::print("  light     {:.0f} lm\n", piece.lamp->lumens);
  if (piece.price) fmt::print("  price     {:.2f}\n", *piece.price);
  if (!piece.slots.empty()) fmt::print("  slots     {}\n", fmt::join(piece.slots, ", "));
  for (const PieceParameter& p : piece.parameters)
    fmt::print("  parameter {} = {} ({} to {})\n", p.name, p.value, p.min, p.max);
}

}  // namespace

Job describeCatalog(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.require_subcommand(1);
  const auto common = [&](CLI::App* sub) {
    sub->add_flag("--json", options->json, "Print JSON on standard output");
    sub->add_option("--language", options->language, "Language of names, for instance th or fr");
  };
  CLI::App* list = app.add_subcommand("list", "List the pieces, or with --category those of one");
  list->add_option("--category", options->category, "Only this category");
  common(list);
  CLI::App* search =
      app.add_subcommand("search", "Search names, translations, tags, categories and creators");
  search->add_option("WORDS", options->query, "What to look for")->required();
  common(search);
  CLI::App* showOne = app.add_subcommand("show", "Show one piece with its creator and licence");
  showOne->add_option("ID", options->id, "Id of the piece, as listed")->required();
  common(showOne);
  return [options, list, search] {
    const Catalog catalog;
    if (list->parsed()) {
      std::vector<CatalogPiecePtr> pieces;
      for (auto& piece : catalog.pieces()) {
        if (options->category.empty() || piece->category == options->category) pieces.push_back(piece);
      }
      printTable(pieces, *options);
      printProblems(catalog);
      return 0;
    }
    if (search->parsed()) {
      const std::string words = fmt::format("{}", fmt::join(options->query, " "));
      const auto found = catalog.search(words);
      printTable(found, *options);
      printProblems(catalog);
      if (found.empty()) fmt::print(stderr, "idap: nothing in the catalog matches '{}'\n", words);
      return found.empty() ? 1 : 0;
    }
    const CatalogPiecePtr piece = catalog.find(options->id);
    if (!piece)
      throw Error("no piece '" + options->id + "' in the catalog; look for it with 'idap catalog search'");
    show(*piece, *options);
    return 0;
  };
}

}  // namespace idap::cli
