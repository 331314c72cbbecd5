#include "model/edits/picture_edits.h"

#include <algorithm>
#include <functional>

namespace idap {

namespace {

constexpr const char* kFolder = "pictures/";

Home withAssets(const Home& home, const std::function<void(Assets&)>& change) {
  Home next = home;
  auto assets = std::make_shared<Assets>(*home.assets);
  change(*assets);
  next.assets = std::move(assets);
  return next;
}

}  // namespace

Home addPicture(const Home& home, PictureId id, Picture picture, SharedBytes png) {
  std::string stem = kFolder;
  stem += std::to_string(id.value);
  do {
    picture.asset = stem;
    picture.asset += ".png";
    stem += '-';
  } while (home.assets->contains(picture.asset));
  Home next = withAssets(home, [&](Assets& assets) { assets[picture.asset] = std::move(png); });
  next.pictures.set(id, std::move(picture));
  next.nextId = std::max(next.nextId, id.value + 1);
  return next;
}

Home removePicture(const Home& home, PictureId id) {
  const Picture* picture = home.pictures.find(id);
  if (!picture) return home;
  const std::string asset = picture->asset;
  const bool shared = std::any_of(home.pictures.begin(), home.pictures.end(), [&](const auto& entry) {
    return entry.first != id && entry.second->asset == asset;
  });
  Home next = shared ? home : withAssets(home, [&](Assets& assets) { assets.erase(asset); });
  next.pictures.erase(id);
  return next;
}

Home renamePicture(const Home& home, PictureId id, const std::string& name) {
  const Picture* picture = home.pictures.find(id);
  if (!picture) return home;
  Home next = home;
  Picture renamed = *picture;
  renamed.name = name;
  next.pictures.set(id, std::move(renamed));
  return next;
}

bool sameDesign(const Home& a, const Home& b) {
  const auto bare = [](const Home& home) {
    Home rest = home;
    rest.pictures = {};
    rest.nextId = 1;
    if (std::any_of(home.assets->begin(), home.assets->end(),
                    [](const auto& entry) { return entry.first.starts_with(kFolder); }))
      rest = withAssets(rest, [](Assets& assets) {
        std::erase_if(assets, [](const auto& entry) { return entry.first.starts_with(kFolder); });
      });
    return rest;
  };
  return bare(a) == bare(b);
}

}  // namespace idap
