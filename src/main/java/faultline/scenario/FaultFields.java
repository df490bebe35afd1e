package faultline.scenario;

import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** The attributes kind and value, which make a fault. */
final class FaultFields {

    private static final Map<String, FaultKind> KINDS = new LinkedHashMap<>();

    static {
        for (FaultKind kind : FaultKind.values()) {
            KINDS.put(kind.fileName(), kind);
        }
    }

    private FaultFields() {
    }

    /** The fault that the attributes describe, empty where the kind is not known. */
    static Optional<Fault> read(Fields fields) {
        Optional<Fault> fault = fields.choice("kind", KINDS).map(kind -> kind.fault(value(fields, kind)));
        fields.text("value");
        return fault;
    }

    private static double value(Fields fields, FaultKind kind) {
        if (kind.takesValue()) {
            return fields.number("value", range(kind), kind.usual());
        }
        fields.text("value").ifPresent(text -> fields.complain("value", text, "none, because a fault of kind " + kind.fileName()
                + " takes no value"));
        return kind.usual();
    }

    private static Range range(FaultKind kind) {
        return Range.closed(Numbers.toText(kind.least()), Numbers.toText(kind.most()), kind.unit().equals("m") ? "metres" : kind.unit());
    }
}
