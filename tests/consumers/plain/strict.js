// Keeps what the browser and the fire complain about.
window.violations = [];
window.failures = [];
document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => {
  violations.push(`${violatedDirective} ${blockedURI}`);
});
// It does not bubble, but it comes by.
addEventListener('error', ({ detail }) => detail && failures.push(detail), true);
