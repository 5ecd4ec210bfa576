declare module 'limn-core' {
  const make: (options: Record<string, unknown>) => Promise<Record<string, unknown>>;
  export default make;
}
declare module 'limn-catalogue' {
  const catalogue: import('./results').Catalogue;
  export default catalogue;
}
