package faultline.campaign.plan;

import faultline.scenario.xml.SourceLocation;
import java.util.LinkedHashMap;
import java.util.Map;

/** A change of a scenario that a plan specifies. */
sealed interface ScenarioChange {

    /** Returns the location of the change in the plan. */
    SourceLocation location();

    /** Sets an attribute. */
    record SetAttribute(AttributePath path, AttributeValue value, SourceLocation location) implements ScenarioChange {}

    /** Adds a {@code fault} with these attributes at the end of the timeline. */
    record AddFault(Map<String, AttributeValue> attributes, SourceLocation location) implements ScenarioChange {
        public AddFault {
            attributes = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(attributes));
        }
    }
}
