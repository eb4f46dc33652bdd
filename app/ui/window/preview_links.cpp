#include "app/ui/window/preview_links.h"

#include "app/model/session/session.h"
#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/branches/branches_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/scene_column.h"

namespace app {

void connectPreviews(Session &session, const PreviewParts &parts)
{
    const auto preview = [&session](std::optional<std::int64_t> frame) {
        frame ? session.preview().show({*frame, 0}) : session.preview().end();
    };
    QObject::connect(&parts.plots, &PlotsPanel::pointedAt, &session, preview);
    QObject::connect(&parts.energy, &EnergyPanel::pointedAt, &session, preview);
    QObject::connect(&parts.branches, &BranchesPanel::pointedAt, &session, preview);
    QObject::connect(&parts.accuracy, &AccuracyPanel::pointedAt, &session, preview);
    QObject::connect(&parts.centre.timeline(), &TimelineStrip::pointedAt, &session, preview);
    QObject::connect(&parts.centre.scene(), &SceneView::bodyPointedAt, &parts.plots,
                     &PlotsPanel::setPointedBody);
    session.onChange(ChangeKind::preview, &parts.plots, [&session, parts] {
        const std::optional<sim::Cursor> &moment = session.preview().marked();
        // Plots show no moments inside a frame: their own cursor is at its start already.
        const bool isFrame = moment && moment->phase == 0;
        const auto frame = isFrame ? std::optional(moment->frame) : std::nullopt;
        parts.plots.setHovered(frame);
        parts.energy.setHovered(frame);
        parts.branches.setHovered(frame);
    });
}

}
