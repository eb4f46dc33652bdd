#include "app/ui/window/scene_column.h"

#include "app/ui/actions/run_commands.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_layout.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/scene/hud/unit_circle.h"
#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/failure_notice.h"
#include "app/ui/window/focus_parameters.h"
#include "app/ui/window/scene_card.h"

#include <QVBoxLayout>

namespace app {

SceneColumn::SceneColumn(Session &session, MeasureSeries &measures, const RunCommands &commands,
                         const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_commands(commands), m_theme(theme),
      m_notice(new Notice(theme, this)),
      m_bar(new SceneBar(session.run(), session.editor(), session.code(), theme, this)),
      m_scene(new SceneView(session, theme, this)),
      m_failure(new FailureNotice(session.run(), session.editor(), theme, m_scene)),
      m_transport(new TransportBar(session, commands, theme, this)),
      m_timeline(new TimelineStrip(session, theme, this)),
      m_footfall(new FootfallStrip(session.run(), session.playback(), session.preview(), measures,
                                   *m_timeline, theme, this)),
      m_column(new QVBoxLayout(this))
{
    styleAsPanel(*this);
    m_scene->setMinimumSize(leastScene);
    (new UnitCircle(*m_scene, theme))->stackUnder(m_failure); // the scene owns it
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    m_column->addWidget(m_notice);
    m_column->addWidget(m_bar);
    m_column->addWidget(divider(this));
    m_column->addWidget(m_scene, 1);
    m_column->addWidget(divider(this));
    m_column->addWidget(m_transport);
    m_column->addWidget(m_timeline);
    connect(&commands, &RunCommands::stepByChanged, m_timeline, &TimelineStrip::setStepBy);
    m_column->addWidget(m_footfall);
}

void SceneColumn::showAlone()
{
    m_footfall->setMaximumHeight(0); // it belongs under the timeline, which moves
    m_transport->insertMiddle(m_timeline);
    m_timeline->setForm(TimelineStrip::Form::trackOnly);
    m_bar->setMiddle(
        new FocusParameters(m_session.run(), m_session.editor(), m_session.playback(), m_theme, m_bar));
    if (!m_card)
        m_card =
            new SceneCard(m_session.run(), m_session.progress(), *m_commands.nextStep, m_theme, *m_scene);
    m_card->show();
    m_scene->setFocus();
}

void SceneColumn::showBesidePanels()
{
    m_card->hide();
    m_bar->setMiddle(nullptr);
    m_transport->removeMiddle(m_timeline);
    m_timeline->setForm(TimelineStrip::Form::whole);
    m_column->insertWidget(m_column->indexOf(m_transport) + 1, m_timeline);
    m_footfall->setMaximumHeight(QWIDGETSIZE_MAX);
    // At once, so that panels that come back find a scene that needs no more room than before.
    m_column->activate();
}

}
