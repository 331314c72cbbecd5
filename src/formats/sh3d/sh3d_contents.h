// The contents of a .sh3d archive (models, textures, pictures), taken over into a home's assets as they are
// asked for.
#pragma once

#include <map>
#include <string>

#include "base/zip.h"
#include "model/home.h"
#include "model/import_report.h"

namespace idap {

class Sh3dContents {
 public:
  explicit Sh3dContents(const ZipReader& archive) : archive_(archive) {}

  // content: what an attribute names, "12" or "12/chair.obj". The asset's path; empty, and a line on the
  // report, when it is missing, damaged or not of that kind. The second time costs nothing.
  std::string model(const std::string& content, const std::string& place, ImportReport& report);
  std::string picture(const std::string& content, const std::string& place, ImportReport& report);

  Assets takeAssets() { return std::move(assets_); }

 private:
  std::string addModel(const std::string& content);
  std::string addArchivedModel(const std::string& folder, SharedBytes bytes);
  std::string addPicture(const std::string& content);
  std::string entryOf(const std::string& content) const;
  SharedBytes read(const std::string& entry);
  template <class Add>
  std::string remembered(std::map<std::string, std::string>& known, const std::string& content,
                         const char* missing, const std::string& place, ImportReport& report, const Add& add);

  const ZipReader& archive_;
  Assets assets_;
  std::map<std::string, std::string> models_, pictures_;  // content -> asset path, empty: unusable
  std::multimap<std::size_t, SharedBytes> bytes_;         // by a hash: equal contents are held once
  std::map<const Bytes*, std::string> pathOf_;            // of bare models and pictures
};

}  // namespace idap
