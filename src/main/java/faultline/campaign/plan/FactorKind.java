package faultline.campaign.plan;

/** The elements of a plan that vary something. */
public enum FactorKind {
    /** An attribute with several values, or a drawn one. */
    SET,
    /** Named sets of attributes. */
    VARIANTS,
    /** Faults, with or without healthy runs. */
    FAULTS,
    /** The sensors that are on. */
    MASKS
}
