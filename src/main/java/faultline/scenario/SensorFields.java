package faultline.scenario;

import faultline.geometry.Vec;
import faultline.sensor.SensorSpec;

/** The attributes of a sensor but its id, in the robot and in the timeline. */
final class SensorFields {

    private SensorFields() {
    }

    /** A sensor whose attributes come from a file, and from another sensor where the file has none. */
    static SensorSpec read(Fields fields, SensorSpec usual) {
        Vec seat = new Vec(fields.number("x", Range.COORDINATE, usual.seat().x()), fields.number("y", Range.COORDINATE, usual.seat().y()));
        return new SensorSpec(usual.id(), seat, fields.angle("bearing", Range.ANGLE, usual.bearing()),
                fields.number("range", Range.SIZE, usual.range()), fields.cone(usual.cone()), fields.flag("on", usual.on()),
                fields.number("noise", Range.NOISE, usual.noise()));
    }
}
