#include "catalog/parametric/declarations.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "base/translatable.h"

namespace idap::parametric {

namespace {

using Kind = PieceParameter::Kind;
using Option = PieceParameter::Option;

struct Name {
  Kind kind;
  const char* label;
};

const std::map<std::string, Name>& names() {
  static const std::map<std::string, Name> all{
      {"apron", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Height of the apron")}},
      {"arm", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Width of the arms")}},
      {"arms", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Arms")}},
      {"axis", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Axis")}},
      {"back", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Back")}},
      {"bar", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Depth of the bar")}},
      {"bars", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Bars")}},
      {"base", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Base")}},
      {"basins", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Basins")}},
      {"bedHeight", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Height of the bed")}},
      {"blades", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Blades")}},
      {"board", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Thickness of the boards")}},
      {"boards", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Boards")}},
      {"books", {Kind::Share, QT_TRANSLATE_NOOP("idap", "How full of books")}},
      {"border", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Width of the border")}},
      {"both", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Drawers on both sides")}},
      {"brackets", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Brackets")}},
      {"buttons", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Buttons")}},
      {"candles", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Candles")}},
      {"channels", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Channels in the back")}},
      {"columns", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Columns")}},
      {"curtains", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Curtains")}},
      {"doors", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Doors")}},
      {"drawers", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Drawers")}},
      {"drop", {Kind::Share, QT_TRANSLATE_NOOP("idap", "How far it hangs down")}},
      {"drops", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Drops of glass")}},
      {"edge", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Edge of the top")}},
      {"feet", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Feet")}},
      {"flaps", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Flaps")}},
      {"flight", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Width of the flight")}},
      {"flowers", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Flowers")}},
      {"footHeight", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Height of the foot")}},
      {"frame", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Width of the frame")}},
      {"fringe", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Fringe")}},
      {"fronds", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Fronds")}},
      {"front", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Fronts")}},
      {"fruits", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Fruits")}},
      {"handle", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Handles")}},
      {"inset", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Legs set in by")}},
      {"leaves", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Leaves")}},
      {"legHeight", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Height of the feet")}},
      {"legs", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Legs")}},
      {"legSize", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Thickness of the legs")}},
      {"mat", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Width of the mat")}},
      {"mattressHeight", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Height of the mattress")}},
      {"mirror", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Mirror")}},
      {"mirrorDoor", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Mirror door number")}},
      {"open", {Kind::Share, QT_TRANSLATE_NOOP("idap", "How far open")}},
      {"oven", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Oven")}},
      {"padded", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Padded seat")}},
      {"paneColumns", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Panes across")}},
      {"paneRows", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Panes up")}},
      {"panels", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Panels")}},
      {"pedestal", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Pedestal")}},
      {"pillows", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Pillows")}},
      {"piping", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Piping")}},
      {"plinth", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Height of the feet")}},
      {"pot", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Pot")}},
      {"pull", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Handles")}},
      {"rounding", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Rounding of the edges")}},
      {"rows", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Rows")}},
      {"sashes", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Sashes")}},
      {"seatHeight", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Seat height")}},
      {"shape", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Shape")}},
      {"shelf", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Shelf below")}},
      {"shelves", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Shelves")}},
      {"sides", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Sides")}},
      {"sill", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Sill")}},
      {"smooth", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Smooth curve")}},
      {"spindles", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Spindles")}},
      {"spots", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Spots")}},
      {"stand", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Stand")}},
      {"stems", {Kind::Count, QT_TRANSLATE_NOOP("idap", "Stems")}},
      {"stretcher", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Stretcher between the legs")}},
      {"style", {Kind::Choice, QT_TRANSLATE_NOOP("idap", "Style")}},
      {"taper", {Kind::Share, QT_TRANSLATE_NOOP("idap", "Width of the end")}},
      {"threshold", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Threshold")}},
      {"topThickness", {Kind::Length, QT_TRANSLATE_NOOP("idap", "Thickness of the top")}},
      {"towel", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Towel")}},
      {"turn", {Kind::Angle, QT_TRANSLATE_NOOP("idap", "Turn")}},
      {"turned", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Turned posts")}},
      {"wallHung", {Kind::Switch, QT_TRANSLATE_NOOP("idap", "Hangs on the wall")}},
  };
  return all;
}

PieceParameter length(const char* name, double min, double max, double start) {
  PieceParameter p = describedParameter(name);
  p.kind = Kind::Length;
  p.min = min, p.max = max, p.value = start;
  return p;
}

PieceParameter share(const char* name, double start) {
  PieceParameter p = length(name, 0, 1, start);
  p.kind = Kind::Share;
  return p;
}

PieceParameter count(const char* name, int min, int max, int start) {
  PieceParameter p = describedParameter(name);
  p.kind = Kind::Count;
  p.whole = true;
  p.min = min, p.max = max, p.value = start;
  return p;
}

PieceParameter flag(const char* name, bool start) {
  PieceParameter p = count(name, 0, 1, start ? 1 : 0);
  p.kind = Kind::Switch;
  return p;
}

// The first option is the generator's own. Homes keep the number of the option: new ones go to the end.
PieceParameter choice(const char* name, std::vector<Option> options) {
  PieceParameter p = count(name, 0, static_cast<int>(options.size()) - 1, 0);
  p.kind = Kind::Choice;
  p.choices = std::move(options);
  return p;
}

PieceParameter fronts() {
  return choice("front", {{"flat", QT_TRANSLATE_NOOP("idap", "Flat")},
                          {"shaker", QT_TRANSLATE_NOOP("idap", "Shaker")},
                          {"panelled", QT_TRANSLATE_NOOP("idap", "Panelled")},
                          {"slats", QT_TRANSLATE_NOOP("idap", "Slats")},
                          {"louvre", QT_TRANSLATE_NOOP("idap", "Louvres")},
                          {"cane", QT_TRANSLATE_NOOP("idap", "Cane")},
                          {"glass", QT_TRANSLATE_NOOP("idap", "Glass")}});
}

const Option kBar{"bar", QT_TRANSLATE_NOOP("idap", "Bars")},
    kKnob{"knob", QT_TRANSLATE_NOOP("idap", "Knobs")}, kCup{"cup", QT_TRANSLATE_NOOP("idap", "Cups")},
    kEdge{"edge", QT_TRANSLATE_NOOP("idap", "Edges")}, kNoHandle{"none", QT_TRANSLATE_NOOP("idap", "None")};

PieceParameter handles() { return choice("handle", {kBar, kKnob, kCup, kEdge, kNoHandle}); }
PieceParameter edgeHandles() { return choice("handle", {kEdge, kKnob, kBar, kCup, kNoHandle}); }
PieceParameter knobHandles() { return choice("handle", {kKnob, kBar, kCup, kEdge, kNoHandle}); }

const Option kPlinth{"plinth", QT_TRANSLATE_NOOP("idap", "Plinth")},
    kTapered{"tapered", QT_TRANSLATE_NOOP("idap", "Tapered")},
    kSplayed{"splayed", QT_TRANSLATE_NOOP("idap", "Splayed")},
    kBlocks{"block", QT_TRANSLATE_NOOP("idap", "Blocks")},
    kMetal{"metal", QT_TRANSLATE_NOOP("idap", "Metal frame")},
    kSledge{"sledge", QT_TRANSLATE_NOOP("idap", "Sledge")},
    kCastors{"castors", QT_TRANSLATE_NOOP("idap", "Castors")},
    kRound{"round", QT_TRANSLATE_NOOP("idap", "Round")},
    kSquare{"square", QT_TRANSLATE_NOOP("idap", "Square")},
    kTurned{"turned", QT_TRANSLATE_NOOP("idap", "Turned")},
    kRectangle{"rectangle", QT_TRANSLATE_NOOP("idap", "Rectangular")},
    kSoft{"soft", QT_TRANSLATE_NOOP("idap", "Soft corners")};

PieceParameter caseFeet() {
  return choice("legs", {kPlinth, kTapered, kSplayed, kBlocks, kMetal, kSledge, kCastors});
}
PieceParameter caseFeetHeight() { return length("legHeight", 0.03, 0.25, 0.1); }
PieceParameter sofaLegs() {
  return choice("legs", {kTapered,
                         kBlocks,
                         {"bun", QT_TRANSLATE_NOOP("idap", "Buns")},
                         {"steel", QT_TRANSLATE_NOOP("idap", "Steel")}});
}
PieceParameter squareEdge() {
  return choice("edge", {kSquare, kRound, {"under", QT_TRANSLATE_NOOP("idap", "Tapered underneath")}});
}
PieceParameter pots() {
  return choice("pot", {kTapered,
                        {"belly", QT_TRANSLATE_NOOP("idap", "Bellied")},
                        {"cylinder", QT_TRANSLATE_NOOP("idap", "Straight")},
                        {"rimmed", QT_TRANSLATE_NOOP("idap", "With a rim")}});
}
PieceParameter axis() {
  return choice("axis", {{"up", QT_TRANSLATE_NOOP("idap", "Upright")},
                         {"across", QT_TRANSLATE_NOOP("idap", "Left to right")},
                         {"deep", QT_TRANSLATE_NOOP("idap", "Front to back")}});
}

const std::map<std::string, std::vector<PieceParameter>>& declared() {
  static const std::map<std::string, std::vector<PieceParameter>> all{
      {"cabinet", {fronts(), handles(), caseFeet(), caseFeetHeight()}},
      {"chestOfDrawers", {count("columns", 1, 4, 1), fronts(), handles(), caseFeet(), caseFeetHeight()}},
      {"wardrobe", {count("drawers", 0, 3, 0), fronts(), handles(), caseFeet(), caseFeetHeight()}},
      {"shoeCabinet", {fronts(), handles()}},
      {"bookcase",
       {caseFeet(), length("plinth", 0.02, 0.25, 0.06), length("board", 0.015, 0.05, 0.022),
        flag("back", true)}},
      {"cubeShelf", {length("board", 0.015, 0.06, 0.03)}},
      {"wallShelf", {length("board", 0.015, 0.06, 0.035), flag("brackets", false)}},
      {"kitchenBase", {fronts(), handles()}},
      {"kitchenSink", {fronts(), handles()}},
      {"kitchenHob", {fronts(), handles()}},
      {"kitchenCorner", {fronts(), handles()}},
      {"kitchenWall", {fronts(), handles()}},
      {"kitchenTall", {fronts(), handles(), flag("oven", false)}},
      {"kitchenIsland", {fronts(), handles()}},
      {"extractorHood",
       {choice("style", {{"pyramid", QT_TRANSLATE_NOOP("idap", "Pyramid")},
                         {"box", QT_TRANSLATE_NOOP("idap", "Box")}})}},
      {"basinCabinet", {fronts(), edgeHandles()}},
      {"washbasin", {flag("pedestal", true)}},
      {"towelRail", {flag("towel", true)}},
      {"legTable",
       {choice("shape", {kRectangle, kRound, kSoft}), choice("legs", {kTapered, kRound, kSquare, kTurned}),
        squareEdge(), length("legSize", 0.025, 0.14, 0.065), length("apron", 0, 0.15, 0.09),
        length("inset", 0, 0.15, 0.04), flag("shelf", false), flag("stretcher", false)}},
      {"pedestalTable",
       {choice("shape", {kRound, kSoft, kRectangle}),
        choice("style", {{"tulip", QT_TRANSLATE_NOOP("idap", "Tulip foot")}, kTurned}),
        choice("edge", {{"under", QT_TRANSLATE_NOOP("idap", "Tapered underneath")}, kSquare, kRound})}},
      {"hairpinTable", {choice("shape", {kRectangle, kRound, kSoft}), squareEdge()}},
      {"desk",
       {choice("style", {{"writing", QT_TRANSLATE_NOOP("idap", "Writing table")},
                         {"pedestal", QT_TRANSLATE_NOOP("idap", "With pedestals")}}),
        choice("pull", {kKnob, kBar, kCup}), flag("both", true)}},
      {"dressingTable", {fronts(), knobHandles()}},
      {"mirror",
       {choice("shape", {kRectangle, kRound, {"arch", QT_TRANSLATE_NOOP("idap", "Arched")}}),
        length("frame", 0.01, 0.08, 0.03)}},
      {"windsorChair",
       {choice("style",
               {{"bow", QT_TRANSLATE_NOOP("idap", "Bow")}, {"comb", QT_TRANSLATE_NOOP("idap", "Comb")}}),
        choice("legs", {kTurned, {"plain", QT_TRANSLATE_NOOP("idap", "Plain")}})}},
      {"shellChair",
       {choice("legs", {{"wood", QT_TRANSLATE_NOOP("idap", "Wooden legs")},
                        {"pedestal", QT_TRANSLATE_NOOP("idap", "Pedestal")},
                        {"sled", QT_TRANSLATE_NOOP("idap", "Sledge")}}),
        flag("arms", false)}},
      {"diningChair", {flag("buttons", false)}},
      {"officeChair",
       {choice("back", {{"mesh", QT_TRANSLATE_NOOP("idap", "Mesh")},
                        {"padded", QT_TRANSLATE_NOOP("idap", "Padded")}}),
        flag("arms", true)}},
      {"barStool", {flag("padded", true), flag("back", false)}},
      {"modernSofa", {sofaLegs(), flag("pillows", true), flag("piping", false)}},
      {"wingChair", {flag("buttons", true)}},
      {"tubChair", {flag("channels", false)}},
      {"pouf", {choice("style", {kRound, {"drum", QT_TRANSLATE_NOOP("idap", "Drum")}, kSquare})}},
      {"framedBed",
       {choice("style", {{"slatted", QT_TRANSLATE_NOOP("idap", "Slatted")},
                         {"panel", QT_TRANSLATE_NOOP("idap", "Panels")},
                         {"metal", QT_TRANSLATE_NOOP("idap", "Metal")}})}},
      {"upholsteredBed",
       {choice("style", {{"tufted", QT_TRANSLATE_NOOP("idap", "Tufted")},
                         {"channels", QT_TRANSLATE_NOOP("idap", "Channels")},
                         {"plain", QT_TRANSLATE_NOOP("idap", "Plain")}})}},
      {"canopyBed", {flag("turned", true), flag("curtains", true)}},
      {"door", {flag("threshold", false)}},
      {"rug", {choice("shape", {kRectangle, kRound}), flag("fringe", false)}},
      {"picture", {length("frame", 0.005, 0.08, 0.02)}},
      {"pendantLamp",
       {choice("style", {{"cone", QT_TRANSLATE_NOOP("idap", "Cone")},
                         {"dome", QT_TRANSLATE_NOOP("idap", "Dome")},
                         {"drum", QT_TRANSLATE_NOOP("idap", "Drum")},
                         {"globe", QT_TRANSLATE_NOOP("idap", "Globe")},
                         {"lantern", QT_TRANSLATE_NOOP("idap", "Paper lantern")}})}},
      {"chandelier", {flag("drops", true)}},
      {"standingLamp",
       {choice("base", {{"disc", QT_TRANSLATE_NOOP("idap", "Disc")},
                        {"tripod", QT_TRANSLATE_NOOP("idap", "Tripod")},
                        {"vase", QT_TRANSLATE_NOOP("idap", "Vase")},
                        {"ball", QT_TRANSLATE_NOOP("idap", "Ball")}})}},
      {"ficus", {pots()}},
      {"monstera", {pots()}},
      {"palm", {pots()}},
      {"cactus", {pots()}},
      {"snakePlant", {pots()}},
      {"flowerVase",
       {choice("style", {{"tulip", QT_TRANSLATE_NOOP("idap", "Tulips")},
                         {"daisy", QT_TRANSLATE_NOOP("idap", "Daisies")}})}},
      {"solid-box", {length("rounding", 0, 0.5, 0)}},
      {"solid-cylinder", {axis(), share("taper", 1), count("sides", 3, 128, 64)}},
      {"solid-sphere", {count("sides", 8, 128, 64)}},
      {"solid-extrusion", {axis()}},
      {"solid-turned", {axis(), flag("smooth", false), count("sides", 8, 128, 64)}},
  };
  return all;
}

}  // namespace

PieceParameter describedParameter(const std::string& name) {
  PieceParameter p;
  p.name = name;
  const auto found = names().find(name);
  if (found == names().end()) {
    p.label = name;
    return p;
  }
  p.label = found->second.label;
  p.kind = found->second.kind;
  return p;
}

void addDeclared(const std::string& generator, const Parameters& given, std::vector<PieceParameter>& to) {
  const auto found = declared().find(generator);
  if (found == declared().end()) return;
  // Shelves without doors and drawers have no fronts to choose.
  const std::string layout = given.text("layout", "d");
  const bool fronts = layout.find_first_of("rdDgGm") != std::string::npos;
  for (PieceParameter p : found->second) {
    if (!fronts && (p.name == "front" || p.name == "handle")) continue;
    if (std::any_of(to.begin(), to.end(), [&](const PieceParameter& other) { return other.name == p.name; }))
      continue;
    if (p.kind == Kind::Choice) {
      const std::string chosen = given.text(p.name, p.choices.front().name);
      const auto at = std::find_if(p.choices.begin(), p.choices.end(),
                                   [&](const Option& option) { return option.name == chosen; });
      if (at == p.choices.end())
        throw std::invalid_argument("'" + chosen + "' is no option of '" + p.name + "'");
      p.value = static_cast<double>(at - p.choices.begin());
    } else {
      p.value = given.number(p.name, p.value);
      p.min = std::min(p.min, p.value);
      p.max = std::max(p.max, p.value);
    }
    to.push_back(std::move(p));
  }
}

}  // namespace idap::parametric
