package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;

class InspectedSensorTest {

    private static MountedCone cone(double degrees) {
        return new MountedCone(0, 0, Math.toRadians(degrees), Math.toRadians(10), 0.8);
    }

    @Test
    void anotherConeReplacesTheTableOfDirections() {
        InspectedSensor sensor = new InspectedSensor(3, cone(0));
        ConeTable table = sensor.table();
        sensor.refit(cone(0));
        assertSame(table, sensor.table());
        sensor.refit(cone(-100));
        assertNotSame(table, sensor.table());
        assertEquals(cone(-100), sensor.cone());
        assertEquals(3, sensor.index());
        assertEquals(8, sensor.bit());
    }
}
