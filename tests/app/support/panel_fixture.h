#pragma once

#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "tests/app/support/session_fixture.h"
#include "tests/app/support/user_input.h"
#include "tests/app/support/waiting.h"

#include <QSize>

namespace tests {

/// Shows a widget as a window of its own and waits until it is active.
void show(QWidget &widget, QSize size);

/// Returns the row of a parameter; null if there is none.
app::ParameterRow *rowOf(const app::ParameterPanel &panel, const QString &id);

/// One panel of the window, shown alone. Further arguments go to the constructor of the panel.
template <class Panel>
struct PanelFixture : SessionFixture
{
    explicit PanelFixture(QSize size) : PanelFixture(twoLessons(), size) {}
    template <class... More>
    PanelFixture(app::LessonLibrary lessons, QSize size, More &&...more)
        : SessionFixture(std::move(lessons)), panel(session, theme, std::forward<More>(more)...)
    {
        show(panel, size);
    }

    Panel panel;
};

}
