#include "app/ui/panels/measure_panel.h"

#include "app/ui/panels/measure_row.h"
#include "app/ui/panels/panel_title.h"

#include <QVBoxLayout>

namespace app {

namespace {

constexpr int bottomMargin = 6;
constexpr qint64 refreshMilliseconds = 100; ///< while playing: numbers that change faster cannot be read

}

MeasurePanel::MeasurePanel(Session &session, const Course &course, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_course(course), m_theme(theme)
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    auto *title = new PanelTitle(tr("Measured"), PanelTitle::CaptionPlace::besideTitle, theme, this);
    title->setCaption(tr("at the cursor"));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, bottomMargin);
    column->setSpacing(0);
    column->setAlignment(Qt::AlignTop);
    column->addWidget(title);
    connect(&session, &Session::stepOpened, this, &MeasurePanel::open);
    connect(&session, &Session::moved, this, &MeasurePanel::refresh);
    connect(&session, &Session::playingChanged, this, &MeasurePanel::refreshNow);
    connect(&session, &Session::glanceChanged, this, &MeasurePanel::refreshNow);
    connect(&course, &Course::changed, this, &MeasurePanel::refresh);
    connect(&theme, &Theme::changed, this, &MeasurePanel::refreshNow);
    open();
}

QSize MeasurePanel::sizeHint() const
{
    return {400, PanelTitle::height + static_cast<int>(m_rows.size()) * MeasureRow::height + bottomMargin};
}

void MeasurePanel::open()
{
    for (MeasureRow *row : m_rows)
        delete row;
    m_rows.clear();
    for (std::size_t i = 0; i < m_session.step().measures.size(); ++i) {
        m_rows.push_back(new MeasureRow(m_session, m_course, i, m_theme, this));
        layout()->addWidget(m_rows.back());
        m_rows.back()->show();
    }
    updateGeometry();
    emit contentChanged();
}

void MeasurePanel::refresh()
{
    if (!m_session.isPlaying() || !m_sinceRefresh.isValid() ||
        m_sinceRefresh.elapsed() >= refreshMilliseconds)
        refreshNow();
}

void MeasurePanel::refreshNow()
{
    m_sinceRefresh.start();
    for (MeasureRow *row : m_rows)
        row->refresh();
}

}
