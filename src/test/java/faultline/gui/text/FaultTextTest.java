package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.robot.MotorFaultKind;
import faultline.sensor.FaultDescriptor;
import faultline.sensor.FaultKind;
import faultline.sensor.SignalFault;
import org.junit.jupiter.api.Test;

class FaultTextTest {

    @Test
    void aNumberHasAsManyDecimalsAsItNeeds() {
        assertEquals("name 0.40 m", text(FaultKind.STUCK, 0.4));
        assertEquals("name 0.002 m/s", text(FaultKind.DRIFT, 0.002));
        assertEquals("name 0.0455 m", text(FaultKind.NOISE, 0.04549));
        assertEquals("name -12.00°", text(FaultKind.MISALIGNED, -12));
        assertEquals("name 0.70", text(MotorFaultKind.WEAK, 0.7));
        assertEquals("name", text(FaultKind.OFF, 0.7));
    }

    @Test
    void burstsOfDifferentLengthsDiffer() {
        assertEquals("dropout in bursts 0.50 1/s of 0.50 s", FaultText.format(new SignalFault.Bursts(0.5, 0.5)));
        assertEquals("dropout in bursts 0.50 1/s of 30.00 s", FaultText.format(new SignalFault.Bursts(0.5, 30)));
    }

    private static String text(FaultDescriptor<?> kind, double value) {
        return FaultText.format("name", kind, value);
    }
}
