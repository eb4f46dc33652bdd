#pragma once

#include "app/model/plot_list.h"
#include "app/model/session.h"
#include "sim/run/script/composed_interval.h"

#include <QMenu>

#include <functional>

namespace app {

/// Chooses what an axis of a plot shows, and of which body. Filled when it opens, for the scene that there is then.
class QuantityMenu : public QMenu
{
    Q_OBJECT

public:
    /// More bodies than these make no list that could be read; the others are selected in the picture.
    static constexpr int mostBodies = 30;

    enum class Axis {
        up,     ///< what is plotted
        across, ///< against what: time, too
    };
    /// `current` tells what the axis shows now.
    QuantityMenu(const Session &session, Axis axis, std::function<Quantity()> current, QWidget *parent);

signals:
    void chosen(const app::Quantity &quantity);

private:
    void fill();
    void addQuantities(const Quantity &current, About about);
    void addDistances(const Quantity &current);
    void addBodies(const Quantity &current);
    QAction *addChoice(QMenu &menu, const QString &text, const Quantity &quantity, bool isCurrent);
    void addRest(QMenu &menu, int count);
    const sim::Scene &scene() const { return m_session.timeline().track().interval().scene; }

    const Session &m_session;
    Axis m_axis;
    std::function<Quantity()> m_current;
};

}
