package faultline.scenario;

import faultline.control.ControllerSpec;
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
record ControllerWriter(XmlWriter out, ControllerSpec.WallFollowing defaults, boolean all)
        implements ControllerSpec.ControllerVisitor<XmlWriter> {

    /** Writes the element. */
    static void write(ControllerSpec spec, XmlWriter out) {
        out.beginElement("controller");
        spec.accept(new ControllerWriter(out, ControllerSpec.WallFollowing.DEFAULT, false));
        out.endElement();
    }

    @Override
    public XmlWriter visit(ControllerSpec.None spec) {
        return out.attribute("type", "none");
    }

    @Override
    public XmlWriter visit(ControllerSpec.Drive spec) {
        return out.attribute("type", "drive")
                .attribute("left", spec.leftVolts())
                .attribute("right", spec.rightVolts());
    }

    @Override
    public XmlWriter visit(ControllerSpec.WallFollowing spec) {
        out.attribute("type", ControllerReader.DEFAULT_TYPE)
                .attribute("distance", spec.distance())
                .attribute("hand", spec.side().fileName())
                .attribute("period", spec.period())
                .attribute("timing", spec.timingRule().fileName());
        if (all || !spec.diagnosis()) {
            out.attribute("diagnosis", ControllerReader.switchText(spec.diagnosis()));
        }
        spec.gainRule().accept(new GainWriter(out, all));
        writeThresholds(spec.thresholds());
        return out;
    }

    @Override
    public XmlWriter visit(ControllerSpec.Extern spec) {
        return out.attribute("type", ControllerReader.EXTERN).attribute("period", spec.period());
    }

    @Override
    public XmlWriter visit(ControllerSpec.Provided spec) {
        out.attribute("type", spec.name()).attribute("period", spec.period());
        new TreeMap<>(spec.settings()).forEach((name, value) -> out.beginElement("setting")
                .attribute("name", name)
                .attribute("value", value)
                .endElement());
        return out;
    }

    @Override
    public XmlWriter visit(ControllerSpec.Chosen spec) {
        return spec.original().accept(this);
    }

    @Override
    public XmlWriter visit(ControllerSpec.Recorded spec) {
        out.attribute("type", ControllerReader.RECORDED)
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

    /** Writes the rule for the gains; the default rule only if all attributes are wanted. */
    private record GainWriter(XmlWriter out, boolean all) implements GainRule.GainRuleVisitor<XmlWriter> {

        @Override
        public XmlWriter visit(GainRule.Automatic rule) {
            return all ? out.attribute("gains", "automatic") : out;
        }

        @Override
        public XmlWriter visit(GainRule.Length rule) {
            return out.attribute("gains", "length").attribute("length", rule.metres());
        }

        @Override
        public XmlWriter visit(GainRule.Fixed rule) {
            return out.attribute("gains", "fixed")
                    .attribute("kp", rule.proportional())
                    .attribute("kd", rule.derivative());
        }
    }
}
