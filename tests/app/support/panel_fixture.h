#pragma once

#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "tests/app/support/session_fixture.h"
#include "tests/app/support/user_input.h"
#include "tests/app/support/waiting.h"

#include <QSize>

#include <type_traits>
#include <utility>

namespace tests {

/// Shows a widget as a window of its own and waits until it is active.
void show(QWidget &widget, QSize size);

/// Returns the row of a parameter; null if there is none.
app::ParameterRow *rowOf(const app::ParameterPanel &panel, const QString &id);

/// Returns a panel with the parts of `session` that it takes.
template <class Panel, class... More>
Panel panelOf(app::Session &session, const app::Theme &theme, More &&...more)
{
    if constexpr (std::is_constructible_v<Panel, app::Session &, const app::Theme &, More...>)
        return Panel(session, theme, std::forward<More>(more)...);
    else if constexpr (std::is_constructible_v<Panel, const app::OpenRun &, app::RunEditor &, app::Playback &,
                                               const app::Theme &, More...>)
        return Panel(session.run(), session.editor(), session.playback(), theme, std::forward<More>(more)...);
    else if constexpr (std::is_constructible_v<Panel, const app::OpenRun &, app::Playback &, app::Preview &,
                                               app::ComparisonRuns &, const app::Theme &, More...>)
        return Panel(session.run(), session.playback(), session.preview(), session.comparisons(), theme,
                     std::forward<More>(more)...);
    else
        return Panel(session.run(), session.playback(), session.preview(), theme,
                     std::forward<More>(more)...);
}

/// One panel of the window, shown alone. Further arguments go to the constructor of the panel.
template <class Panel>
struct PanelFixture : SessionFixture
{
    explicit PanelFixture(QSize size) : PanelFixture(twoLessons(), size) {}
    template <class... More>
    PanelFixture(app::LessonLibrary lessons, QSize size, More &&...more)
        : SessionFixture(std::move(lessons)),
          panel(panelOf<Panel>(session, theme, std::forward<More>(more)...))
    {
        show(panel, size);
    }

    Panel panel;
};

}
