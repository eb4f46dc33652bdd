// What the panel of plots has to begin with, and what its button offers.

#include "app/model/quantity_words.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "sim/run/script/composed_interval.h"

#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QStackedWidget>

namespace app {

QWidget *PlotsPanel::emptyPage()
{
    auto *text =
        new QLabel(tr("Nothing is plotted. <b>Add</b>, above, has curves to begin with: how far down a "
                      "body is, how fast it goes, or one quantity against another."),
                   m_pages);
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    text->setContentsMargins(16, 4, 16, 8);
    return text;
}

QMenu *PlotsPanel::addMenu()
{
    auto *menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillAddMenu(*menu); });
    return menu;
}

void PlotsPanel::fillAddMenu(QMenu &menu)
{
    menu.clear();
    const auto offer = [&](const QString &text, const PlotSpec &plot) {
        QAction *made = menu.addAction(text);
        const sim::Scene &scene = m_session.timeline().track().interval().scene;
        for (const Quantity &one : {m_course.bound(plot.up), m_course.bound(plot.across)}) {
            if (const std::optional<NoValue> why = whyNot(one, scene)) {
                made->setEnabled(false);
                made->setToolTip(noValueWords(one, scene, *why));
            }
        }
        if (m_list.isFull()) {
            made->setEnabled(false);
            made->setToolTip(tr("There are %1 plots: more would be too small to read. Remove one first.")
                                 .arg(PlotList::most));
        }
        connect(made, &QAction::triggered, this, [this, plot] { add(plot); });
    };
    const auto ofTime = [&](Measured what) {
        return offer(tr("%1 against time").arg(measuredTitle(what)), {{what}});
    };
    ofTime(Measured::placeX);
    ofTime(Measured::placeY);
    ofTime(Measured::speed);
    if (m_session.timeline().state().angle.rows() > 0)
        ofTime(Measured::angle);
    ofTime(Measured::energy);
    menu.addSeparator();
    offer(tr("the path: y against x"), {{Measured::placeY}, {Measured::placeX}});
    offer(tr("velocity y against y"), {{Measured::velocityY}, {Measured::placeY}});
    if (m_session.timeline().state().spin.rows() > 0)
        offer(tr("turning speed against angle"), {{Measured::spin}, {Measured::angle}});
    menu.addSeparator();
    QAction *hint = menu.addAction(tr("Anything else: add one, and choose what it shows"));
    hint->setEnabled(false);
    hint->setToolTip(tr("The names above a plot are menus"));
}

void PlotsPanel::add(const PlotSpec &plot)
{
    if (m_list.isFull())
        return;
    m_list.add(plot);
    m_cards.back()->plot().setFocus(Qt::OtherFocusReason);
    QTimer::singleShot(0, m_cards.back(), [this] {
        if (!m_cards.empty())
            m_scroll->ensureWidgetVisible(m_cards.back());
    });
}

}
