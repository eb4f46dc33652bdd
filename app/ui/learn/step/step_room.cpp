#include "app/ui/learn/step/step_room.h"

#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/learn/view_keeper.h"

#include <QCoreApplication>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int leastTries = 92;     ///< px, the least height of the things to try, if they need more
constexpr int mostWhole = 300;     ///< px, the height that showWhole() takes from the things to try, at most
constexpr int separatorHeight = 1; ///< px, of the line above them

/// Calls `scroll` once all widgets have their new heights, unless `box` is gone by then.
template <typename Scroll>
void afterLayout(const QWidget *box, Scroll scroll)
{
    QTimer::singleShot(0, box, [box, scroll] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // each can post another one
        scroll();
        QTimer::singleShot(0, box, scroll); // a text that was hidden gets its last line only with its width
    });
}

}

StepRoom::StepRoom(QWidget &panel)
    : m_panel(panel), m_area(makeScrollArea(panel)), m_keeper(new ViewKeeper(*m_area))
{
    QWidget *page = makePage();
    // The height of the text depends on its width, so the height at the minimum width must be ignored.
    page->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    m_scrolled = makeColumn(page);
    m_column = makeColumn(&panel);
    m_area->setWidget(page);
    // The text takes only the height that it needs, so that the tasks follow directly below it.
    m_column->addWidget(m_area, 1000);
}

void StepRoom::addText(QVBoxLayout *text)
{
    m_scrolled->addLayout(text);
    m_scrolled->addStretch(1);
}

void StepRoom::addBelow(QWidget *heading, QWidget *tries, QWidget *buttons)
{
    m_heading = heading;
    m_tries = tries;
    m_buttons = buttons;
    m_tryArea = makeScrollArea(m_panel);
    m_tryArea->setObjectName("tries");
    m_tryArea->setWidget(tries);
    for (QWidget *clear : {m_tryArea->viewport(), tries})
        clear->setAutoFillBackground(false); // the panel behind them has the colour
    m_column->addWidget(divider(&m_panel));
    m_column->addWidget(heading);
    m_column->addWidget(m_tryArea);
    m_column->addStretch(1);
    m_column->addWidget(buttons);
}

void StepRoom::fit(int leastText)
{
    const int text = page()->layout()->totalHeightForWidth(m_panel.width());
    const int tries = triesHeight();
    const QWidget *whole = m_keeper->wanted();
    const int least =
        whole ? std::max(leastText, std::min(whole->heightForWidth(whole->width()), mostWhole)) : leastText;
    const int left = m_panel.height() - aroundTries() - std::min(text, least);
    m_tryArea->setFixedHeight(std::clamp(left, std::min(tries, leastTries), tries));
    m_area->setMaximumHeight(std::max(1, text));
}

int StepRoom::aroundTries() const
{
    return separatorHeight + m_heading->sizeHint().height() + m_buttons->sizeHint().height();
}

int StepRoom::triesHeight() const
{
    const QLayout &layout = *m_tries->layout();
    // Without texts that wrap, the height for a width would be -1.
    return layout.hasHeightForWidth() ? layout.totalHeightForWidth(m_panel.width())
                                      : layout.totalSizeHint().height();
}

int StepRoom::fullHeight() const
{
    return m_area->maximumHeight() + leastHeight() - m_area->minimumSizeHint().height();
}

int StepRoom::leastHeight() const
{
    return m_area->minimumSizeHint().height() + triesHeight() + aroundTries();
}

void StepRoom::showTopOf(const QWidget *box)
{
    m_keeper->forget();
    m_keeper->release();
    afterLayout(box, [this, box] {
        if (!m_keeper->wanted()) // nothing else was shown since
            bar().setValue(box->y());
    });
}

void StepRoom::showWhole(QWidget *box)
{
    m_keeper->keep(*box);
}

void StepRoom::showTry(QWidget *box)
{
    if (box->heightForWidth(box->width()) > m_tryArea->height())
        m_keeper->release(); // the next fit() gives it more room
    keepInView(*box);
}

}
