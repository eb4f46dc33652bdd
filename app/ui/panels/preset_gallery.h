#pragma once

#include "app/model/session.h"
#include "app/ui/panels/card_gallery.h"

#include <functional>
#include <map>

namespace app {

/// Paints what a step looks like with a preset's values.
using PresetPainter = std::function<QPixmap(const lessons::Step &, const lessons::Preset &, QSize)>;

/// The presets of the open step as pictures: a click starts the step anew with one of them.
class PresetGallery : public CardGallery
{
    Q_OBJECT

public:
    PresetGallery(Session &session, const Theme &theme, PresetPainter painter, QWidget *parent = nullptr);

protected:
    std::vector<Card> contents() const override;
    QPixmap picture(std::size_t index) override;
    void take(std::size_t index) override;

private:
    Session &m_session;
    PresetPainter m_painter;
    std::map<QString, QPixmap> m_pictures; ///< painted before, by step, preset and scheme
};

}
