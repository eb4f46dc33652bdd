#include "app/ui/window/preview_links.h"

#include "app/model/session/preview.h"
#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/branches/branches_panel.h"
#include "app/ui/branches/difference_plot.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/scene_column.h"

namespace app {

void connectPreviews(const OpenRun &run, Preview &preview, const PreviewParts &parts)
{
    const auto show = [&preview](std::optional<std::int64_t> frame) {
        frame ? preview.show({*frame, 0}) : preview.end();
    };
    QObject::connect(&parts.plots, &PlotsPanel::pointedAt, &parts.centre, show);
    QObject::connect(&parts.energy.plot(), &EnergyPlot::pointedAt, &parts.centre, show);
    QObject::connect(&parts.branches.plot(), &DifferencePlot::pointedAt, &parts.centre, show);
    QObject::connect(&parts.accuracy, &AccuracyPanel::pointedAt, &parts.centre, show);
    QObject::connect(&parts.centre.timeline(), &TimelineStrip::pointedAt, &parts.centre, show);
    QObject::connect(&parts.centre.scene(), &SceneView::bodyPointedAt, &parts.plots,
                     &PlotsPanel::setPointedBody);
    run.onChange(ChangeKind::preview, &parts.plots, [&preview, parts] {
        const std::optional<sim::Cursor> &moment = preview.marked();
        // Plots show no moments inside a frame: their own cursor is at its start already.
        const bool isFrame = moment && moment->phase == 0;
        const auto frame = isFrame ? std::optional(moment->frame) : std::nullopt;
        parts.plots.setHovered(frame);
        parts.energy.plot().setHovered(frame);
        parts.branches.plot().setHovered(frame);
    });
}

}
