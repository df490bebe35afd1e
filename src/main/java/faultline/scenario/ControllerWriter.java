package faultline.scenario;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.BuiltInCases;
import faultline.control.ControllerSpec.ControllerCases;
import faultline.control.GainRule;
import faultline.control.RecordedDecision;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.scenario.xml.XmlWriter;
import java.util.List;
import java.util.TreeMap;

/**
 * Writes the attributes and children of a controller element.
 *
 * @param out the target, with the element begun
 * @param defaults the values that a reader uses for omitted thresholds
 * @param all whether a follower's diagnosis and gains are written even if they have their default values
 */
record ControllerWriter(XmlWriter out, ControllerSpec.WallFollowing defaults, boolean all) {

    /** Writes the element. */
    static void write(ControllerSpec spec, XmlWriter out) {
        out.beginElement("controller");
        new ControllerWriter(out, ControllerSpec.WallFollowing.DEFAULT, false).write(spec);
        out.endElement();
    }

    /** Writes a controller into the open element. */
    XmlWriter write(ControllerSpec spec) {
        return spec.match(new ControllerCases<>(
                builtIn -> builtIn.matchBuiltIn(new BuiltInCases<>(
                        none -> out.attribute("type", ControllerSpec.None.TYPE),
                        drive -> out.attribute("type", ControllerSpec.Drive.TYPE)
                                .attribute("left", drive.leftVolts())
                                .attribute("right", drive.rightVolts()),
                        this::writeFollower)),
                extern -> writeDistance(
                        out.attribute("type", ControllerSpec.Extern.TYPE).attribute("period", extern.period()),
                        extern.wanted()),
                this::writeProvided,
                chosen -> write(chosen.original()),
                this::writeRecorded));
    }

    private XmlWriter writeFollower(ControllerSpec.WallFollowing spec) {
        out.attribute("type", ControllerSpec.WallFollowing.TYPE)
                .attribute("distance", spec.distance())
                .attribute("hand", spec.side().fileName())
                .attribute("period", spec.period())
                .attribute("timing", spec.timingRule().fileName());
        if (all || !spec.diagnosis()) {
            out.attribute("diagnosis", ControllerReader.switchText(spec.diagnosis()));
        }
        writeGains(spec.gainRule());
        writeThresholds(spec.thresholds());
        return out;
    }

    /** Writes the rule for the gains; the default rule only if all attributes are wanted. */
    private void writeGains(GainRule rule) {
        rule.match(new GainRule.GainCases<>(
                automatic -> all ? out.attribute("gains", "automatic") : out,
                length -> out.attribute("gains", "length").attribute("length", length.metres()),
                fixed -> out.attribute("gains", "fixed")
                        .attribute("kp", fixed.proportional())
                        .attribute("kd", fixed.derivative())));
    }

    private XmlWriter writeProvided(ControllerSpec.Provided spec) {
        writeDistance(out.attribute("type", spec.name()).attribute("period", spec.period()), spec.wanted());
        new TreeMap<>(spec.settings()).forEach((name, value) -> out.beginElement("setting")
                .attribute("name", name)
                .attribute("value", value)
                .endElement());
        return out;
    }

    /** Writes the distance of a controller from outside, unless it is the one that is used without the attribute. */
    private static XmlWriter writeDistance(XmlWriter out, double wanted) {
        boolean isDefault = Double.compare(wanted, ControllerSpec.WallFollowing.DEFAULT.distance()) == 0;
        return isDefault ? out : out.attribute("distance", wanted);
    }

    private XmlWriter writeRecorded(ControllerSpec.Recorded spec) {
        out.attribute("type", ControllerSpec.Recorded.TYPE)
                .attribute("distance", spec.wanted())
                .attribute("ticks", String.valueOf(spec.ticks()));
        writeDecisions(spec);
        return out;
    }

    private void writeThresholds(Thresholds thresholds) {
        for (Threshold threshold : Threshold.values()) {
            double value = thresholds.get(threshold);
            if (Double.compare(value, defaults.thresholds().get(threshold)) != 0) {
                out.attribute(threshold.fileName(), value);
            }
        }
    }

    /** Writes one element for each stretch of decisions with the same state and reason. */
    private void writeDecisions(ControllerSpec.Recorded recorded) {
        List<RecordedDecision> decisions = recorded.decisions();
        int next = 0;
        while (next < decisions.size()) {
            RecordedDecision first = decisions.get(next);
            StringBuilder text = new StringBuilder();
            boolean same = true;
            while (same) {
                RecordedDecision decision = decisions.get(next++);
                boolean last = next == decisions.size();
                long end = last
                        ? Math.max(decision.tick() + 1, recorded.ticks())
                        : decisions.get(next).tick();
                text.append(text.isEmpty() ? "" : " ").append(DecisionText.format(decision, end));
                same = !last
                        && decisions.get(next).state().equals(first.state())
                        && decisions.get(next).condition().equals(first.condition());
            }
            out.beginElement("decisions")
                    .attribute("from", String.valueOf(first.tick()))
                    .attribute("state", first.state())
                    .attribute("why", first.condition())
                    .endTextElement(text.toString());
        }
    }
}
