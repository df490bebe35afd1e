package faultline.scenario;

import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;

/** The attributes of a sensor but its id, in the robot and in the timeline. */
final class SensorAttributes {

    private SensorAttributes() {}

    /** A sensor whose attributes come from a file, and from another sensor where the file has none. */
    static SensorSpec read(AttributeReader fields, SensorSpec usual) {
        Vector2 seat = new Vector2(
                fields.number("x", NumberRange.COORDINATE, usual.mountPosition().x()),
                fields.number("y", NumberRange.COORDINATE, usual.mountPosition().y()));
        return new SensorSpec(
                usual.id(),
                seat,
                fields.angle("bearing", NumberRange.ANGLE, usual.bearing()),
                fields.number("range", NumberRange.SIZE, usual.range()),
                fields.cone(usual.cone()),
                fields.flag("on", usual.on()),
                fields.number("noise", NumberRange.NOISE, usual.noise()));
    }
}
