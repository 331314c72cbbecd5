// Catalog pieces as elements of a home.
#include "catalog/catalog.h"

namespace idap {
namespace {

Piece makePiece(const CatalogPiece& from, Vec3 position, double angle) {
  Piece piece;
  piece.name = from.name;
  piece.model.catalogId = from.id;
  piece.position = position + Vec3{0, 0, from.elevation};
  piece.size = from.size;
  piece.angle = angle;
  piece.price = from.price;
  if (!from.creator.empty()) piece.properties["creator"] = from.creator;
  if (!from.license.empty() && !from.library.empty()) piece.properties["license"] = from.license;
  return piece;
}

}  // namespace

Furniture makeFurniture(const CatalogPiece& piece, Vec3 position, double angle) {
  Furniture furniture;
  static_cast<Piece&>(furniture) = makePiece(piece, position, angle);
  furniture.lamp = piece.lamp;
  furniture.staircaseCutOut = piece.staircaseCutOut;
  furniture.dropOnTopHeight = piece.dropOnTopHeight;
  return furniture;
}

Opening makeOpening(const CatalogPiece& piece, Vec3 position, double angle) {
  Opening opening;
  static_cast<Piece&>(opening) = makePiece(piece, position, angle);
  opening.kind = piece.kind == PieceKind::Door     ? OpeningKind::Door
                 : piece.kind == PieceKind::Window ? OpeningKind::Window
                                                   : OpeningKind::Bare;
  opening.cutOut = piece.cutOut;
  opening.cutsBothSides = piece.cutsBothSides;
  opening.wallThickness = piece.wallThickness;
  opening.wallDistance = piece.wallDistance;
  opening.sashes = piece.sashes;
  return opening;
}

}  // namespace idap
