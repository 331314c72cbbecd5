// Changing some elements of a table; ids that do not exist are passed over. For the edits of this folder.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "model/table.h"

namespace idap {

template <class IdType>
std::set<IdType> setOf(const std::vector<IdType>& ids) {
  return {ids.begin(), ids.end()};
}
template <class IdType>
std::vector<IdType> listOf(const std::set<IdType>& ids) {
  return {ids.begin(), ids.end()};
}

template <class IdType, class T, class F>
void changeEach(Table<IdType, T>& table, const std::vector<IdType>& ids, F change) {
  for (const IdType id : ids)
    if (const T* found = table.find(id)) {
      T copy = *found;
      change(copy);
      table.set(id, std::move(copy));
    }
}

// Changes those that a question is answered yes for, and copies no others.
template <class IdType, class T, class Question, class F>
void changeWhere(Table<IdType, T>& table, Question question, F change) {
  for (const auto& [id, element] : table) {
    if (!question(*element)) continue;
    T copy = *element;
    change(copy);
    table.set(id, std::move(copy));
  }
}

template <class IdType, class T>
void eraseEach(Table<IdType, T>& table, const std::vector<IdType>& ids) {
  for (const IdType id : ids) table.erase(id);
}

}  // namespace idap
