#pragma once

#include "app/model/sandbox/sandbox_editor.h"
#include "app/model/sandbox/sandbox_properties.h"
#include "app/ui/theme/theme.h"

#include <QPointer>
#include <QWidget>

#include <vector>

class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace app {

class BuildGuide;
class Command;
struct Commands;
class EffectSwitches;
class ExampleGallery;
class GuideBox;
class GuideRing;
class NameRow;
class PanelTitle;
class ProjectDesk;
class PropertyRow;
class SandboxCommands;

/// The left panel of a sandbox: the tools, the properties of the selected parts, and the effects of the whole
/// scene.
class BuildPanel : public QWidget
{
    Q_OBJECT

public:
    /// `build` has the tools. All arguments must outlive this.
    BuildPanel(const OpenRun &run, RunEditor &changes, Playback &playback, SandboxEditor &editor,
               BuildGuide &guide, const SandboxCommands &build, const Commands &commands, const Theme &theme,
               QWidget *parent = nullptr);
    ~BuildPanel() override;

    /// Shows the project that the learner works on in the sandbox. `desk` must outlive this object.
    void showProject(ProjectDesk &desk);

    /// Scrolls to the properties of the selected parts if they are out of view.
    void showProperties();

    /// Returns the text that is shown if nothing is selected, or if the scene cannot be edited now.
    QString hint() const;
    const std::vector<PropertyRow *> &rows() const { return m_rows; }
    /// Returns the row with the name of the selected point; null unless a single point is selected.
    NameRow *nameRow() const { return m_name; }
    ExampleGallery &gallery() const { return *m_gallery; }
    const GuideBox &guideBox() const { return *m_guideBox; }

    QSize minimumSizeHint() const override { return {240, 300}; }

signals:
    /// The learner wants to go back to the lessons.
    void leaving();

private:
    QWidget *palette(const SandboxCommands &build);
    QWidget *page(const Command &restart);
    QWidget *beginning(QWidget *parent);
    QWidget *feet(const Command &learn);
    QLabel *heading(const QString &text);
    /// Returns how to use the current tool.
    QString toolHint() const;
    QString waitHint() const;
    void refresh();
    void refreshTitle();
    void refreshProperties();
    void makeRows(std::vector<SandboxProperty> properties);
    void clearRows();
    /// Returns what the rows of these properties depend on, besides titles.
    QString keyOf(const std::vector<SandboxProperty> &properties) const;
    /// Shows other titles of the same properties: a point may have another name.
    void showSections(const std::vector<SandboxProperty> &properties);
    void makeGaitHelp();
    /// Moves the highlight ring to the control that the guide asks for.
    void pointOut();
    QWidget *targetControl() const;

    const OpenRun &m_run;
    RunEditor &m_changes;
    Playback &m_playback;
    SandboxEditor &m_editor;
    BuildGuide &m_guide;
    const Theme &m_theme;
    PanelTitle *m_title;
    GuideBox *m_guideBox;
    QPointer<GuideRing> m_ring;
    QList<QToolButton *> m_tools; ///< one per BuildTool
    EffectSwitches *m_effects;
    QScrollArea *m_area;
    QWidget *m_begin;      ///< starts the guide
    QWidget *m_away;       ///< says that the scene cannot be edited now, with a button to frame 0
    QLabel *m_hint;        ///< shown in place of the properties
    QWidget *m_properties; ///< of the selected parts
    QVBoxLayout *m_column; ///< layout of the properties
    std::vector<QLabel *> m_headings;
    NameRow *m_name = nullptr;
    std::vector<PropertyRow *> m_rows;
    QString m_shownKey; ///< identifies the properties that the rows show
    ExampleGallery *m_gallery;
};

}
