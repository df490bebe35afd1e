package faultline.paint;

import faultline.sensor.FaultKind;
import java.awt.Font;
import java.util.function.Function;

/**
 * The few words that a picture has in it. Those in files are {@link #ENGLISH}, so that a file is the same whoever wrote it.
 *
 * @param collision before the place and the moment of the first collision
 * @param faults before the faults that there were then
 * @param off before the sensors that were switched off then
 * @param switchedOff beside a sensor that is switched off
 * @param fault what a kind of fault is called
 * @param font that they are written in
 */
public record Words(String collision, String faults, String off, String switchedOff, Function<FaultKind, String> fault, Font font) {

    /** For files that no window writes. */
    public static final Words ENGLISH = new Words("First collision", "Faults then", "Switched off then", "off", FaultKind::fileName, Brush.FONT);
}
