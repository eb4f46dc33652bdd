#pragma once

#include "app/model/series/plot_list.h"
#include "app/model/session/open_run.h"
#include "sim/run/script/composed_interval.h"

#include <QMenu>

#include <functional>

namespace app {

/// A menu of the quantities that an axis of a plot can show, and of which body. It is filled when it opens, for the
/// scene of that moment.
class QuantityMenu : public QMenu
{
    Q_OBJECT

public:
    /// The longest list of bodies that is still readable. The learner selects other bodies in the scene.
    static constexpr int mostBodies = 30;

    enum class Axis {
        up,     ///< the quantity that is plotted
        across, ///< the quantity against which it is plotted, or time
    };
    /// `current` returns the quantity that the axis shows now.
    QuantityMenu(const OpenRun &run, Axis axis, std::function<Quantity()> current, QWidget *parent);

signals:
    void chosen(const app::Quantity &quantity);

private:
    void fill();
    void addQuantities(const Quantity &current, About about);
    void addDistances(const Quantity &current);
    void addBodies(const Quantity &current);
    QAction *addChoice(QMenu &menu, const QString &text, const Quantity &quantity, bool isCurrent);
    void addRest(QMenu &menu, int count);
    const sim::Scene &scene() const { return m_run.timeline().track().interval().scene; }

    const OpenRun &m_run;
    Axis m_axis;
    std::function<Quantity()> m_current;
};

}
