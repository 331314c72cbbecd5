#include "catalog/model_file_assimp.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <cstring>
#include <map>

#include "base/error.h"
#include "catalog/model_file_material.h"

namespace idap {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{512} << 20;
constexpr std::size_t kMaxCorners = 100'000'000;  // after instances are unfolded
constexpr unsigned kMaxDepth = 256;

class MemoryStream : public Assimp::IOStream {
 public:
  MemoryStream(SharedBytes owner, const Bytes& bytes) : owner_(std::move(owner)), bytes_(bytes) {}

  std::size_t Read(void* target, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
    if (whole > 0) std::memcpy(target, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    if (offset > bytes_.size() - base) return aiReturn_FAILURE;
    at_ = base + offset;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return at_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  SharedBytes owner_;
  const Bytes& bytes_;
  std::size_t at_ = 0;
};

class SiblingSystem : public Assimp::IOSystem {
 public:
  SiblingSystem(const Bytes& model, std::string modelName, const SiblingFiles& siblings)
      : model_(model), modelName_(std::move(modelName)), siblings_(siblings) {}

  bool Exists(const char* file) const override { return file == modelName_ || find(file) != nullptr; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (std::strchr(mode, 'w') || std::strchr(mode, 'a')) return nullptr;
    if (file == modelName_) return new MemoryStream(nullptr, model_);
    SharedBytes bytes = find(file);
    if (!bytes) return nullptr;
    const Bytes& content = *bytes;
    return new MemoryStream(std::move(bytes), content);
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  SharedBytes find(std::string path) const {
    if (!siblings_) return nullptr;
    std::replace(path.begin(), path.end(), '\\', '/');
    while (path.starts_with("./")) path.erase(0, 2);
    return siblings_(path);
  }

  const Bytes& model_;
  std::string modelName_;
  const SiblingFiles& siblings_;
};

class Reporter : public Assimp::ProgressHandler {
 public:
  explicit Reporter(const Progress& progress) : progress_(progress) {}
  bool Update(float share) override {
    if (share >= 0 && share <= 1) progress_.report(double(share), "");
    return !progress_.cancelled();
  }

 private:
  const Progress& progress_;
};

std::string textOf(const aiString& s) { return {s.data, s.length}; }

// Pictures inside the file are reached by the name that the material uses for them.
SiblingFiles withEmbedded(const aiScene& scene, const SiblingFiles& siblings) {
  return [&scene, &siblings](const std::string& path) -> SharedBytes {
    if (const aiTexture* picture = scene.GetEmbeddedTexture(path.c_str())) {
      if (picture->mHeight != 0 || picture->mWidth == 0)
        return nullptr;  // raw texels: no format here writes them
      const auto* data = reinterpret_cast<const std::byte*>(picture->pcData);
      return std::make_shared<Bytes>(data, data + picture->mWidth);
    }
    return siblings ? siblings(path) : nullptr;
  };
}

Color colorOf(const aiColor3D& c) {
  return {std::clamp(c.r, 0.f, 1.f), std::clamp(c.g, 0.f, 1.f), std::clamp(c.b, 0.f, 1.f)};
}

float encoded(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

SurfaceModel::Slot slotOf(const aiMaterial& from, bool gltf, const SiblingFiles& siblings) {
  PhongMaterial phong;
  aiString text;
  if (from.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) phong.name = textOf(text);
  aiColor3D color;
  if (from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS) phong.diffuse = colorOf(color);
  if (from.Get(AI_MATKEY_COLOR_SPECULAR, color) == aiReturn_SUCCESS) phong.specular = colorOf(color);
  if (from.Get(AI_MATKEY_COLOR_EMISSIVE, color) == aiReturn_SUCCESS)
    phong.emission = {color.r, color.g, color.b};
  float number = 0;
  if (from.Get(AI_MATKEY_SHININESS, number) == aiReturn_SUCCESS && number >= 0)
    phong.exponent = double(number);
  if (from.Get(AI_MATKEY_OPACITY, number) == aiReturn_SUCCESS && number >= 0 && number <= 1)
    phong.opacity = double(number);
  if (from.Get(AI_MATKEY_REFRACTI, number) == aiReturn_SUCCESS) phong.ior = double(number);
  if (from.GetTexture(aiTextureType_DIFFUSE, 0, &text) == aiReturn_SUCCESS) phong.diffuseMap = textOf(text);
  if (from.GetTexture(aiTextureType_NORMALS, 0, &text) == aiReturn_SUCCESS) phong.normalMap = textOf(text);
  std::replace(phong.diffuseMap.begin(), phong.diffuseMap.end(), '\\', '/');
  std::replace(phong.normalMap.begin(), phong.normalMap.end(), '\\', '/');
  if (gltf) phong.diffuse = {encoded(phong.diffuse.r), encoded(phong.diffuse.g), encoded(phong.diffuse.b)};

  Material material = materialOf(phong, SlotRole::Plain, siblings);
  if (gltf) {
    material.metalness = 1;
    material.roughness = 1;
    if (from.Get(AI_MATKEY_METALLIC_FACTOR, number) == aiReturn_SUCCESS)
      material.metalness = std::clamp(double(number), 0.0, 1.0);
    if (from.Get(AI_MATKEY_ROUGHNESS_FACTOR, number) == aiReturn_SUCCESS)
      material.roughness = std::clamp(double(number), 0.0, 1.0);
    if (from.Get(AI_MATKEY_TRANSMISSION_FACTOR, number) == aiReturn_SUCCESS && number > 0)
      material.transmission = std::clamp(double(number), 0.0, 1.0);
  }
  return {phong.name, std::move(material)};
}

class Collector {
 public:
  Collector(const aiScene& scene, PolygonModel& model) : scene_(scene), model_(model) {}

  void add(const aiNode& node, const aiMatrix4x4& above, unsigned depth = 0) {
    if (depth > kMaxDepth) return;
    const aiMatrix4x4 here = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
      if (node.mMeshes[i] < scene_.mNumMeshes) add(*scene_.mMeshes[node.mMeshes[i]], here);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], here, depth + 1);
  }

 private:
  void add(const aiMesh& mesh, const aiMatrix4x4& here) {
    const auto base = std::int32_t(model_.positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = here * mesh.mVertices[i];
      model_.positions.push_back({p.x, p.y, p.z});
    }
    const auto normalBase = std::int32_t(model_.normals.size());
    if (mesh.HasNormals()) {
      aiMatrix3x3 carry(here);
      carry.Inverse().Transpose();
      for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const aiVector3D n = carry * mesh.mNormals[i];
        model_.normals.push_back({n.x, n.y, n.z});
      }
    }
    const auto uvBase = std::int32_t(model_.uvs.size());
    const bool hasUvs = mesh.HasTextureCoords(0);
    if (hasUvs)
      for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        model_.uvs.push_back({mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y});
    const bool mirrored = aiMatrix3x3(here).Determinant() < 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (model_.corners.size() + face.mNumIndices > kMaxCorners) return;
      const auto first = std::uint32_t(model_.corners.size());
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        const auto index = std::int32_t(face.mIndices[mirrored ? face.mNumIndices - 1 - i : i]);
        model_.corners.push_back({base + index, hasUvs ? uvBase + index : PolygonModel::kNone,
                                  mesh.HasNormals() ? normalBase + index : PolygonModel::kNone});
      }
      model_.faces.push_back({first, face.mNumIndices, mesh.mMaterialIndex, 1});
    }
  }

  const aiScene& scene_;
  PolygonModel& model_;
};

}  // namespace

PolygonModel readWithAssimp(const Bytes& bytes, const std::string& name, const std::string& extension,
                            const SiblingFiles& siblings, const Progress* progress) {
  if (bytes.size() > kMaxBytes) throw ParseError(name, "", "the model is too large");
  const std::string inner = "model." + extension;
  Assimp::Importer importer;
  importer.SetIOHandler(new SiblingSystem(bytes, inner, siblings));    // the importer owns it
  if (progress) importer.SetProgressHandler(new Reporter(*progress));  // the importer's too
  const aiScene* scene = importer.ReadFile(inner, aiProcess_SortByPType | aiProcess_ValidateDataStructure);
  if (progress) progress->check();
  if (!scene || !scene->mRootNode) throw ParseError(name, "", importer.GetErrorString());
  PolygonModel model;
  const SiblingFiles files = withEmbedded(*scene, siblings);
  const bool gltf = extension == "gltf" || extension == "glb";
  for (unsigned i = 0; i < scene->mNumMaterials; ++i)
    model.slots.push_back(slotOf(*scene->mMaterials[i], gltf, files));
  if (model.slots.empty()) model.slots.push_back({"default", {}});
  aiMatrix4x4 upright;  // STL has no axes of its own; what is printed stands on its z
  if (extension == "stl") aiMatrix4x4::RotationX(float(-kPi / 2), upright);
  Collector(*scene, model).add(*scene->mRootNode, upright);
  for (PolygonModel::Face& face : model.faces)
    if (face.slot >= model.slots.size()) face.slot = 0;
  return model;
}

}  // namespace idap
