// The languages that the program speaks, switched while it runs.
#pragma once

#include <QString>
#include <vector>

namespace idap {

struct Language {
  const char* code;  // "th"
  const char* name;  // in itself: "ไทย"
};
const std::vector<Language>& languages();
QString languageOrEnglish(const QString& code);

// Puts every widget of the application into a language: each gets QEvent::LanguageChange. A language whose
// translation is not installed shows English.
void applyLanguage(const QString& code);

}  // namespace idap
