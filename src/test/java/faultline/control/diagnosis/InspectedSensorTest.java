package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

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

    @Test
    void theMeasurementsOfAnotherConeAreForgotten() {
        InspectedSensor sensor = new InspectedSensor(3, cone(0));
        sensor.measurements().add(0, 0, 0, 1, 0, 0.5, 0);
        sensor.refit(cone(0));
        assertTrue(sensor.measurements().has(0));
        sensor.refit(cone(-100));
        assertFalse(sensor.measurements().has(0));
    }
}
