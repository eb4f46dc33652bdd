#pragma once

#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "app/ui/window/main_window.h"

#include <QToolButton>
#include <QtTest>

/// A window with a gauge and its panel, driven as a learner drives them.
struct StabilityPanelBench
{
    app::LessonLibrary library = app::LessonLibrary::load({LESSON_DIR});
    app::Theme theme{app::Scheme::light};
    app::Session session{library};
    app::MainWindow window{session, theme, noStudy};
    app::StabilityGauge &gauge = *window.findChild<app::StabilityGauge *>();
    app::StabilityPanel &panel = *window.findChild<app::StabilityPanel *>();

    explicit StabilityPanelBench(const char *lesson = "two_body", const char *step = "mutual");
    /// Waits for a reading of the session as it is.
    void settle();
    /// Waits for a whole map.
    void mapped();
    /// The button of the map of that place in MapPlane.
    QToolButton *plane(int index) const;
    template <class Widget>
    bool isSeen() const
    {
        return window.findChild<Widget *>()->isVisible();
    }

private:
    /// In place of a study that takes seconds.
    static sim::Accuracy noStudy(const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &);
};

/// Settings that no other test sees.
void useOwnSettings();
QColor colourAt(QWidget &widget, QPointF place);
bool isNear(const QColor &a, const QColor &b);
