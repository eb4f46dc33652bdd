#include "app/ui/window/focus_parameters.h"

#include "app/model/session/offered_parameters.h"
#include "app/ui/parameters/parameter_row.h"

#include <algorithm>

namespace app {

namespace {

constexpr int leastField = 150; ///< px that slider and number need
constexpr int wantedField = 200;

}

FocusParameters::FocusParameters(const OpenRun &run, RunEditor &editor, const Playback &playback,
                                 const Theme &theme, QWidget *parent)
    : QWidget(parent), m_run(run), m_editor(editor), m_theme(theme), m_pace(playback)
{
    setObjectName("focusParameters");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    run.onChange(ChangeKind::step, this, &FocusParameters::open);
    run.onChange(ChangeKind::run | ChangeKind::playing, this, &FocusParameters::refresh);
    run.onChange(ChangeKind::cursor, this, [this] {
        if (m_pace.isDue())
            refresh();
    });
    open();
}

void FocusParameters::open()
{
    for (ParameterRow *row : m_rows) {
        row->hide();
        row->deleteLater(); // its own signal may have opened a step
    }
    m_rows.clear();
    for (const lessons::Parameter *parameter : offeredParameters(m_run, m_editor)) {
        if (m_rows.size() == most)
            break;
        m_rows.push_back(
            new ParameterRow(m_run, m_editor, *parameter, m_theme, this, ParameterRow::Form::brief));
        m_rows.back()->setColumns(m_rows.back()->wantedLabelWidth(), 0);
    }
    updateGeometry();
    fit();
}

void FocusParameters::refresh()
{
    m_pace.restart();
    for (ParameterRow *row : m_rows)
        row->refresh();
}

QSize FocusParameters::sizeHint() const
{
    int wide = 0;
    for (const ParameterRow *row : m_rows)
        wide += row->wantedLabelWidth() + wantedField;
    return {wide, ParameterRow::height};
}

void FocusParameters::fit()
{
    std::size_t shown = 0;
    int needed = 0;
    for (; shown < m_rows.size(); ++shown) {
        const int least = m_rows[shown]->wantedLabelWidth() + leastField;
        if (needed + least > width())
            break;
        needed += least;
    }
    const int spare = shown > 0 ? (width() - needed) / static_cast<int>(shown) : 0;
    const int more = std::min(spare, wantedField - leastField);
    int x = width() - needed - more * static_cast<int>(shown); // at the right, beside "Show"
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const int wide = m_rows[i]->wantedLabelWidth() + leastField + more;
        m_rows[i]->setVisible(i < shown);
        m_rows[i]->setGeometry(x, (height() - ParameterRow::height) / 2, wide, ParameterRow::height);
        x += wide;
    }
}

void FocusParameters::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fit();
}

}
