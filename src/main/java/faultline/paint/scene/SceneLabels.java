package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import faultline.sensor.FaultKind;
import java.awt.Font;
import java.util.function.Function;

/**
 * The few words that a picture has in it. Those in files are {@link #ENGLISH}, so that a file is the same whoever wrote
 * it.
 *
 * @param collision before the place and the moment of the first collision
 * @param faults before the faults that there were then
 * @param sensorsOff before the sensors that were switched off then
 * @param switchedOff beside a sensor that is switched off
 * @param faultName what a kind of fault is called
 * @param font that they are written in
 */
public record SceneLabels(
        String collision,
        String faults,
        String sensorsOff,
        String switchedOff,
        Function<FaultKind, String> faultName,
        Font font) {

    /** For files that no window writes. */
    public static final SceneLabels ENGLISH = new SceneLabels(
            "First collision", "Active faults", "Switched off", "off", FaultKind::fileName, DrawContext.DEFAULT_FONT);
}
