// Which methods the panel of accuracy shows: three of them, or all.

#include "app/ui/measure/accuracy_panel.h"
#include "app/ui/measure/work_precision_plot.h"

#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>

#include <set>

namespace app {

QPushButton *AccuracyPanel::choiceButton(const char *name, const QString &text, const QString &tip, bool all)
{
    auto *button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setAutoDefault(false);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, all] {
        const bool hadFocus = m_all->hasFocus() || m_fewer->hasFocus();
        QSettings().setValue(showsAllKey, all);
        setShowsAll(all);
        if (hadFocus) // the button is gone, the other one is there
            (all ? m_fewer : m_all)->setFocus(Qt::OtherFocusReason);
    });
    return button;
}

QString AccuracyPanel::captionOf(const sim::Accuracy &accuracy) const
{
    if (accuracy.previewed > 0)
        return tr("first %1 frames of %2").arg(accuracy.previewed).arg(accuracy.span);
    std::set<std::string> methods, shown;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        methods.insert(row.setup.method->id());
        if (m_workPrecision->shown().has(*row.setup.method))
            shown.insert(row.setup.method->id());
    }
    const auto frames = accuracy.horizon > 0 ? accuracy.horizon : accuracy.span;
    return shown.size() == methods.size()
               ? tr("%1 frames, %2 methods").arg(frames).arg(methods.size())
               : tr("%1 frames, %2 of %3 methods").arg(frames).arg(shown.size()).arg(methods.size());
}

void AccuracyPanel::setShowsAll(bool all)
{
    if (all == m_showsAll)
        return;
    m_showsAll = all;
    if (!all)
        setView(errorAgainstTime);
    refresh();
}

/// The step's own method and the most telling others. Before there are times nobody knows which those are: until then the
/// plot is of the step's own.
void AccuracyPanel::chooseMethods()
{
    ShownMethods shown{showsAll()};
    const sim::Accuracy *accuracy = m_study.accuracy();
    if (!shown.areAll && accuracy) {
        const Session &session = m_study.session();
        const std::string own = session.step().script().method->id();
        const bool isEarly = m_study.stage() == AccuracyStudy::Stage::measuring;
        const std::vector<std::string> telling =
            isEarly ? std::vector<std::string>{own}
                    : tellingMethods(*accuracy, own, m_workPrecision->target());
        shown.ids = {telling.begin(), telling.end()};
        shown.ids.insert(session.timeline().script().method->id());
    }
    for (int i = 0; i < m_views->count(); ++i)
        static_cast<SpotPlot *>(m_views->widget(i))->setShown(shown);
}

}
