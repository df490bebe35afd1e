package faultline.gui.canvas;

import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.paint.scene.SceneLabels;
import faultline.paint.surface.DrawContext;
import faultline.sensor.FaultKind;
import java.awt.Font;

/** The labels of scenes in the user's language. */
public final class LocalizedLabels {

    private LocalizedLabels() {}

    /** Returns the font of labels, scaled with the text size of the window. */
    static Font font() {
        return TextSize.scaledFont(DrawContext.DEFAULT_FONT.getStyle(), DrawContext.DEFAULT_FONT.getSize());
    }

    static SceneLabels create() {
        return create(font());
    }

    public static SceneLabels create(Font font) {
        return new SceneLabels(
                Messages.get("picture.collision"),
                Messages.get("picture.faults"),
                Messages.get("picture.off"),
                Messages.get("reading.off"),
                FaultText::motors,
                kind -> kind == FaultKind.OFF ? Messages.get("picture.fault.off") : FaultText.nameOf(kind),
                font);
    }
}
