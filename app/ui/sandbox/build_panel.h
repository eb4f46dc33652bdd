#pragma once

#include "app/model/built_properties.h"
#include "app/model/workbench.h"
#include "app/ui/theme/theme.h"

#include <QPointer>
#include <QWidget>

#include <vector>

class QActionGroup;
class QLabel;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace app {

class BuildGuide;
class EffectSwitches;
class ExampleGallery;
class GuideBox;
class GuideRing;
class PanelTitle;
class PropertyRow;

/// The left panel while a scene is built: tools, what can be set of what is chosen, and what acts on the whole scene.
class BuildPanel : public QWidget
{
    Q_OBJECT

public:
    /// `tools`: the commands that take a tool, in the order of BuildTool. All must outlive this.
    BuildPanel(Session &session, Workbench &bench, BuildGuide &guide, const QList<QAction *> &tools,
               const Theme &theme, QWidget *parent = nullptr);
    ~BuildPanel() override;

    /// What is said where nothing is chosen, or building has to wait.
    QString hint() const;
    const std::vector<PropertyRow *> &rows() const { return m_rows; }
    ExampleGallery &gallery() const { return *m_gallery; }
    const GuideBox &guideBox() const { return *m_guideBox; }

    QSize minimumSizeHint() const override { return {240, 300}; }

signals:
    /// The learner wants to go back to the lessons.
    void leaving();

private:
    QWidget *palette(const QList<QAction *> &tools);
    QWidget *page();
    QWidget *beginning(QWidget *parent);
    QWidget *feet();
    QLabel *heading(const QString &text);
    /// What to do with the tool in hand, and why it has to wait.
    QString toolHint() const;
    QString waitHint() const;
    void refresh();
    void refreshTitle();
    void refreshProperties();
    void makeRows(std::vector<BuiltProperty> properties);
    void makeGaitHelp();
    /// Puts the ring round the control that the guide asks for.
    void pointOut();
    QWidget *askedControl() const;

    Session &m_session;
    Workbench &m_bench;
    BuildGuide &m_guide;
    const Theme &m_theme;
    PanelTitle *m_title;
    GuideBox *m_guideBox;
    QPointer<GuideRing> m_ring;
    QList<QToolButton *> m_tools; ///< one a BuildTool
    EffectSwitches *m_effects;
    QScrollArea *m_area;
    QWidget *m_begin;      ///< where the guide is begun
    QWidget *m_away;       ///< says that building has to wait, with the way to the start
    QLabel *m_hint;        ///< in place of properties
    QWidget *m_properties; ///< of what is chosen
    QVBoxLayout *m_column; ///< of those
    std::vector<PropertyRow *> m_rows;
    QString m_shownKey; ///< which properties the rows are of
    ExampleGallery *m_gallery;
};

}
