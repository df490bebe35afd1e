package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import faultline.robot.MotorSide;
import faultline.sensor.FaultDescriptor;
import java.awt.Font;
import java.util.function.Function;

/**
 * The texts in a picture. Files use {@link #ENGLISH}, so that they do not depend on the language of the window.
 *
 * @param collision the label before the position and time of the first collision
 * @param faults the label before the faults at that time
 * @param sensorsOff the label before the sensors that were switched off at that time
 * @param switchedOff the label beside a sensor that is switched off
 * @param motors returns the name of a side's motors
 * @param faultName returns the name of a kind of fault of a sensor or a motor
 * @param font the font of the texts
 */
public record SceneLabels(
        String collision,
        String faults,
        String sensorsOff,
        String switchedOff,
        Function<MotorSide, String> motors,
        Function<FaultDescriptor<?>, String> faultName,
        Font font) {

    /** The texts in files. */
    public static final SceneLabels ENGLISH = new SceneLabels(
            "First collision",
            "Active faults",
            "Switched off",
            "off",
            side -> side.fileName() + " motors",
            FaultDescriptor::fileName,
            DrawContext.DEFAULT_FONT);
}
