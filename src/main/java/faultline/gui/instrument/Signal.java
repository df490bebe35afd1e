package faultline.gui.instrument;

import faultline.engine.record.Channels;
import faultline.gui.text.Texts;
import faultline.gui.theme.Theme;
import faultline.paint.plot.Dash;
import faultline.world.SensorSnapshot;
import java.util.ArrayList;
import java.util.List;

/**
 * What a strip chart can show: lines that belong together.
 *
 * @param name for the choice
 * @param unit of all its lines
 * @param curves from the lowest to the topmost
 */
record Signal(String name, String unit, List<Curve> curves) {

    Signal {
        curves = List.copyOf(curves);
    }

    /** Everything that can be shown of a robot with these sensors. */
    static List<Signal> of(List<SensorSnapshot> sensors) {
        List<Signal> signals = new ArrayList<>();
        signals.add(pair("distance", "m", Channels.MEASURED, Channels.WANTED));
        signals.add(pair("terms", "rad/s", Channels.PROPORTIONAL, Channels.DERIVATIVE));
        signals.add(pair("volts", "V", Channels.LEFT_VOLTS, Channels.RIGHT_VOLTS));
        for (int i = 0; i < sensors.size(); i++) {
            signals.add(sensor(sensors.get(i).spec().id(), i));
        }
        return signals;
    }

    private static Signal pair(String key, String unit, int first, int second) {
        String texts = "signal." + key;
        return new Signal(Texts.text(texts), unit, List.of(Curve.of(Texts.text(texts + ".second"), second, 1, Dash.DASHED),
                Curve.of(Texts.text(texts + ".first"), first, 0, Dash.SOLID)));
    }

    private static Signal sensor(String id, int index) {
        Curve truth = new Curve(Texts.text("signal.sensor.truth"), Channels.truth(index), theme -> theme.palette().text(), Dash.DOTTED);
        Curve reported = new Curve(Texts.text("signal.sensor.reported"), Channels.reported(index),
                theme -> theme.palette().sensor(index).outline(), Dash.SOLID);
        return new Signal(Texts.text("signal.sensor", id), "m", List.of(reported, truth));
    }

    @Override
    public String toString() {
        return name;
    }
}
