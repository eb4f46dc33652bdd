#include "app/model/text/scene_words.h"

#include <QCoreApplication>

namespace app {

namespace {

struct CircleText
{
    Q_DECLARE_TR_FUNCTIONS(UnitCircle)
};

struct LegendText
{
    Q_DECLARE_TR_FUNCTIONS(HudText)
};

}

UnitCircleWords unitCircleWords()
{
    UnitCircleWords words;
    words.title = CircleText::tr("Unit circle");
    words.noLength = CircleText::tr("The arrow has no length,");
    words.noDirection = CircleText::tr("so it has no direction.");
    words.angle = CircleText::tr("angle = %1° = %2\u2009rad");
    //: cosine = 40 / 50 = 0.8
    words.side = CircleText::tr("%1 = %2 / %3 = %4");
    words.cosine = CircleText::tr("cosine");
    words.beside = CircleText::tr("the side beside the angle");
    words.sine = CircleText::tr("sine");
    words.opposite = CircleText::tr("the side opposite the angle");
    //: Pythagoras: 0.8² + 0.6² = 1
    words.pythagoras = CircleText::tr("%1² + %2² = 1");
    words.down = CircleText::tr("y points down: a sine above 0 is down");
    return words;
}

QString velocityScaleWords()
{
    return LegendText::tr("velocity of %1\u2009px/frame");
}

QString pullScaleWords()
{
    return LegendText::tr("pull of %1\u2009px/frame²");
}

QString onionWords()
{
    return LegendText::tr("every %1 frames");
}

}
