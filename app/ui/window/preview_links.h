#pragma once

namespace app {

class AccuracyPanel;
class BranchesPanel;
class EnergyPanel;
class OpenRun;
class PlotsPanel;
class Preview;
class SceneColumn;

/// The parts of the window that preview a moment while the mouse points at it, or mark a moment that another part
/// previews.
struct PreviewParts
{
    SceneColumn &centre;
    PlotsPanel &plots;
    EnergyPanel &energy;
    BranchesPanel &branches;
    AccuracyPanel &accuracy;
};

/// Connects the parts, so that all show the moment that the mouse points at in one of them.
void connectPreviews(const OpenRun &run, Preview &preview, const PreviewParts &parts);

}
