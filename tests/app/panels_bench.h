#pragma once

#include "app/model/session.h"
#include "app/ui/panels/parameter_panel.h"
#include "app/ui/panels/parameter_row.h"
#include "app/ui/theme/theme.h"

/// What the suites of the panels share: two small lessons and hands to type with.
namespace app {

/// Settings of the tests' own, and the program's style. Once, before all.
void prepareProgram();
/// No try is done.
void forgetProgress();

/// "one" has the steps "first" (with a try: wait five frames) and "second"; "two" has "many", with seven parameters,
/// among them a choice ("formula") and a count ("feet").
LessonLibrary twoLessons();

/// A library, a session and a theme for one test.
struct World
{
    explicit World(LessonLibrary given = twoLessons()) : library(std::move(given)), session(library) {}

    LessonLibrary library;
    Session session;
    Theme theme{Scheme::light};
};

/// Shows a widget as a window of its own, active.
void show(QWidget &widget, const QSize &size);
/// The row of a parameter; null if there is none.
ParameterRow *rowOf(const ParameterPanel &panel, const QString &id);
/// Clicks a field, replaces its text, and ends with a key.
void type(QWidget &box, const QString &text, Qt::Key end = Qt::Key_Return);

}
